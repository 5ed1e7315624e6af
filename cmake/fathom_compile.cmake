# How everything of ours is compiled: fathom_compile(<target>), for each library and program.
#
# - Sources are compiled in batches (FATHOM_BATCHES), since most of the time of a source goes into
#   reading headers. Names in anonymous namespaces therefore differ within a folder. A batch names its
#   sources from the top of the project, where CMake's own unity builds write absolute paths: ccache then
#   knows it in any clone.
# - The headers that nearly every source reads are read once, before all of them
#   (FATHOM_PRECOMPILED_HEADERS). Each source still includes what it uses: preset `each` builds without
#   both, one source at a time.
# - Templates that many sources need are compiled once, where headers are precompiled: fathom_templates.
option(FATHOM_BATCHES "Compile the sources of a folder in batches" ON)
option(FATHOM_PRECOMPILED_HEADERS "Read std, Eigen and fmt once for all sources" ON)

# lld links in a fifth of the time of GNU ld, and lets go of the shared libraries that only dropped
# functions ask for. GNU ld links the same, with more libraries to load at each start.
find_program(FATHOM_LLD ld.lld)
mark_as_advanced(FATHOM_LLD)

# -Wrestrict, -Warray-bounds, -Wstringop-overflow and -overread: GCC 12 sees overlaps and ends of
# std::string that are not there (GCC bug 105651), and in precompiled headers it no longer knows that they
# are the system's.
# -Wmaybe-uninitialized: it takes the string in an EffectSetting that is written in place for unset.
function(fathom_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
      -Wno-maybe-uninitialized>
    $<$<BOOL:${FATHOM_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# GCC collects its garbage some ten times in a source, a tenth of its time: not below 400 MB, where it now
# peaks 100 MB higher, at 0.7 to 1.1 GB for the largest. The same for precompiled headers and who takes them.
function(fathom_collect_less_garbage target)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=400000>)
endfunction()

# Precompiled headers only serve a target that finds and defines the same.
function(fathom_see_common_packages target)
  foreach(package IN ITEMS Eigen3::Eigen fmt::fmt)
    target_include_directories(${target} SYSTEM PRIVATE
      $<BUILD_INTERFACE:$<TARGET_PROPERTY:${package},INTERFACE_INCLUDE_DIRECTORIES>>)
    target_compile_definitions(${target} PRIVATE
      $<BUILD_INTERFACE:$<TARGET_PROPERTY:${package},INTERFACE_COMPILE_DEFINITIONS>>)
  endforeach()
endfunction()

# Puts batches of eight in the place of a target's sources, but for generated ones and those with the
# property SKIP_UNITY_BUILD_INCLUSION.
function(fathom_batch_sources target)
  get_target_property(sources ${target} SOURCES)
  set(single "")
  set(batched "")
  foreach(source IN LISTS sources)
    get_source_file_property(is_single ${source} SKIP_UNITY_BUILD_INCLUSION)
    cmake_path(IS_ABSOLUTE source is_generated)
    if(is_single OR (is_generated AND source MATCHES "^${PROJECT_BINARY_DIR}/"))
      list(APPEND single ${source})
    else()
      cmake_path(ABSOLUTE_PATH source NORMALIZE)
      cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
      list(APPEND batched "#include \"${source}\"\n")
    endif()
  endforeach()
  set(batches "")
  list(LENGTH batched count)
  set(first 0)
  while(first LESS count)
    list(SUBLIST batched ${first} 8 includes)
    list(JOIN includes "" CONTENT)
    set(batch ${CMAKE_CURRENT_BINARY_DIR}/${target}_from_${first}.cc)
    file(CONFIGURE OUTPUT ${batch} CONTENT "${CONTENT}" @ONLY)
    list(APPEND batches ${batch})
    math(EXPR first "${first} + 8")
  endwhile()
  set_target_properties(${target} PROPERTIES SOURCES "${batches};${single}")
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()

# Code that may stand in the Python module, which is a shared library. Not CMake's own property: that
# compiles programs in another way, which precompiled headers do not serve. A call within a source may
# still be inlined, so that this costs no time.
function(fathom_allow_shared_library target)
  if(FATHOM_PYTHON)
    target_compile_options(${target} PRIVATE -fPIC -fno-semantic-interposition)
  endif()
endfunction()

# Programs take from these libraries only the functions that they reach: with OpenCV's imgcodecs and FFmpeg
# come 220 shared libraries, which take 0.15 s to load at each start. Names of folders.
set(fathom_folders_with_heavy_packages camera detect film images track)

function(fathom_drop_what_is_not_reached target)
  string(REGEX REPLACE "^fathom_" "" folder ${target})
  if(folder IN_LIST fathom_folders_with_heavy_packages)
    target_compile_options(${target} PRIVATE -ffunction-sections -fdata-sections)
  endif()
  target_link_options(${target} PRIVATE
    -Wl,--gc-sections -Wl,--as-needed $<$<BOOL:${FATHOM_LLD}>:-fuse-ld=lld>)
endfunction()

# Folders that read, word and write. At -O1 they compile in two thirds of the time, and no run shows it.
# Precompiled headers bring their -O along, so that there are two.
set(fathom_folders_that_compute_little
  archive check comparison exporting manoeuvres open_log ordinary_dives process python report starter tools)

function(fathom_optimise_less target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
endfunction()

# fathom_compile(<target> [HEADERS <target>]): HEADERS holds the precompiled headers.
function(fathom_compile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADERS" "")
  if(NOT arg_HEADERS)
    set(arg_HEADERS fathom_common_headers)
    cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
    if(folder IN_LIST fathom_folders_that_compute_little)
      set(arg_HEADERS fathom_light_headers)
      fathom_optimise_less(${target})
    endif()
    fathom_allow_shared_library(${target})
  endif()
  fathom_set_warnings(${target})
  fathom_collect_less_garbage(${target})
  fathom_drop_what_is_not_reached(${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(FATHOM_BATCHES)
    fathom_batch_sources(${target})
    # GCC takes a source inside a batch for a header, whose classes may not use its anonymous names.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
  if(FATHOM_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${arg_HEADERS})
    fathom_see_common_packages(${target})
    # ccache asks for it.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    if(NOT target STREQUAL fathom_templates)
      target_link_libraries(${target} PRIVATE fathom::templates)
    endif()
  endif()
endfunction()

# fathom_precompile(<name> <header>... [LINKS <target>...]): headers to read once.
function(fathom_precompile name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINKS")
  if(NOT FATHOM_PRECOMPILED_HEADERS)
    return()
  endif()
  add_library(${name} OBJECT ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/precompiled.cc)
  fathom_set_warnings(${name})
  fathom_collect_less_garbage(${name})
  if(name MATCHES "^fathom_(common|light)_headers$")
    fathom_allow_shared_library(${name})
  endif()
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_precompile_headers(${name} PRIVATE ${arg_UNPARSED_ARGUMENTS} <common_templates.h>)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  fathom_see_common_packages(${name})
  target_link_libraries(${name} PRIVATE ${arg_LINKS})
endfunction()

# What common_templates.h says is compiled once. Behind fathom_precompile(fathom_common_headers).
function(fathom_compile_common_templates)
  if(NOT FATHOM_PRECOMPILED_HEADERS)
    return()
  endif()
  add_library(fathom_templates STATIC cmake/common_templates.cc)
  add_library(fathom::templates ALIAS fathom_templates)
  set_target_properties(fathom_templates PROPERTIES EXPORT_NAME templates)
  fathom_compile(fathom_templates)
  install(TARGETS fathom_templates EXPORT FathomTargets COMPONENT development)
endfunction()
