# One library per folder: fathom_add_library(<folder> SOURCES ... DEPENDS ... [PRIVATE_DEPENDS ...]).
#
# DEPENDS is the only place where one folder is allowed to know another. Each library carries an
# include directory of its own that holds nothing but fathom/<folder>, so that an include of a
# folder that is not among the dependencies fails to compile.
function(fathom_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS")
  set(include_dir ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${include_dir}/fathom)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_dir}/fathom/${name} SYMBOLIC)

  add_library(fathom_${name} STATIC ${arg_SOURCES})
  add_library(fathom::${name} ALIAS fathom_${name})
  set_target_properties(fathom_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_compile_features(fathom_${name} PUBLIC cxx_std_20)
  fathom_set_warnings(fathom_${name})
  target_include_directories(fathom_${name} PUBLIC
    $<BUILD_INTERFACE:${include_dir}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(fathom_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})

  install(TARGETS fathom_${name} EXPORT FathomTargets)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom/${name}
          FILES_MATCHING PATTERN "*.h" PATTERN web EXCLUDE)
endfunction()

# -Wrestrict: GCC 12 sees overlaps in std::string that are not there (GCC bug 105651).
# -Wmaybe-uninitialized: it takes the string in an EffectSetting that is written in place for unset.
function(fathom_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>
    $<$<BOOL:${FATHOM_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
