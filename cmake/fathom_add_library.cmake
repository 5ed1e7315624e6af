# One library per folder, named after it:
#
#   fathom_add_library(<folder>
#     FLOORS <sub-folder>...     from the lowest to the highest; each uses only those before it
#     HEADERS <header>...        what other folders and users of the library may include; installed
#     SOURCES <file>...
#     DEPENDS <target>...        what its headers include
#     PRIVATE_DEPENDS <target>... what only its .cc files include)
#
# DEPENDS and PRIVATE_DEPENDS are the only place where one folder gets to know another:
# check_includes.cmake refuses every other include, when this is configured and as a test. A folder
# knows only what was added before it.
function(fathom_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FLOORS;HEADERS;SOURCES;DEPENDS;PRIVATE_DEPENDS")
  get_filename_component(storey ${CMAKE_CURRENT_SOURCE_DIR}/../.. ABSOLUTE)
  foreach(target IN LISTS arg_DEPENDS arg_PRIVATE_DEPENDS)
    if(NOT TARGET ${target})
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt: there is no ${target} yet. "
                          "A folder depends on those that are added before it.")
    endif()
  endforeach()

  add_library(fathom_${name} STATIC ${arg_SOURCES})
  add_library(fathom::${name} ALIAS fathom_${name})
  set_target_properties(fathom_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_compile_features(fathom_${name} PUBLIC cxx_std_20)
  fathom_compile(fathom_${name})
  target_include_directories(fathom_${name} PUBLIC
    $<BUILD_INTERFACE:${storey}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(fathom_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})

  install(TARGETS fathom_${name} EXPORT FathomTargets COMPONENT development)
  foreach(header IN LISTS arg_HEADERS)
    cmake_path(GET header PARENT_PATH sub_folder)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fathom/${name}/${sub_folder}
            COMPONENT development)
  endforeach()

  foreach(what IN ITEMS FLOORS HEADERS DEPENDS PRIVATE_DEPENDS)
    set_property(GLOBAL PROPERTY fathom_${name}_${what} ${arg_${what}})
  endforeach()
  set_property(GLOBAL PROPERTY fathom_${name}_FOLDER ${CMAKE_CURRENT_SOURCE_DIR})
  set_property(GLOBAL APPEND PROPERTY fathom_folders ${name})
endfunction()

# Sets `result` to CMake code that lists, for each folder, the packages that a program which links it
# has to find: fathom_packages_<folder>. A package is named by its targets: Ceres of Ceres::ceres.
function(fathom_packages_by_folder result)
  get_property(folders GLOBAL PROPERTY fathom_folders)
  set(text "")
  foreach(name IN LISTS folders)
    get_property(targets GLOBAL PROPERTY fathom_${name}_DEPENDS)
    get_property(private_targets GLOBAL PROPERTY fathom_${name}_PRIVATE_DEPENDS)
    set(packages_${name} "")
    foreach(target IN LISTS targets private_targets)
      if(target MATCHES "^fathom::(.*)$")
        list(APPEND packages_${name} ${packages_${CMAKE_MATCH_1}})
        continue()
      endif()
      string(REGEX REPLACE "::.*" "" package ${target})
      list(APPEND packages_${name} ${package})
    endforeach()
    list(REMOVE_DUPLICATES packages_${name})
    list(JOIN packages_${name} " " packages)
    string(APPEND text "set(fathom_packages_${name} ${packages})\n")
  endforeach()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# Writes what the folders have declared into `file`, for check_includes.cmake.
function(fathom_write_folders file)
  get_property(folders GLOBAL PROPERTY fathom_folders)
  set(text "set(folders ${folders})\n")
  foreach(name IN LISTS folders)
    foreach(what IN ITEMS FOLDER FLOORS HEADERS DEPENDS PRIVATE_DEPENDS)
      get_property(value GLOBAL PROPERTY fathom_${name}_${what})
      string(APPEND text "set(${name}_${what} ${value})\n")
    endforeach()
  endforeach()
  string(REPLACE ";" " " text "${text}")
  file(WRITE ${file} "${text}")
endfunction()
