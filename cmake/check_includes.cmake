# Holds the includes of every folder against what its CMakeLists.txt declares (fathom_add_library):
#
#   cmake -DFOLDERS=<file of fathom_write_folders> -P check_includes.cmake
#
# - An include of another folder is named in DEPENDS, or, from a .cc file, in PRIVATE_DEPENDS; and
#   what is named there is included.
# - Of another folder only its HEADERS are included, and these include no others of their own.
# - A sub-folder includes none that stands after it in FLOORS.
# - An include is the path of a file, from src/ or problems/.

cmake_minimum_required(VERSION 3.22)
include(${FOLDERS})

set(num_faults 0)
macro(fault)
  message(SEND_ERROR ${ARGN})
  math(EXPR num_faults "${num_faults} + 1")
endmacro()

foreach(name IN LISTS folders)
  cmake_path(GET ${name}_FOLDER PARENT_PATH fathom_dir)
  cmake_path(GET fathom_dir PARENT_PATH ${name}_STOREY)
endforeach()

# The folder's sub-folder that holds `path`; "" for the folder itself.
function(floor_of path result)
  string(REGEX MATCH "^([^/]*)/" unused "${path}")
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

foreach(name IN LISTS folders)
  set(folder ${${name}_FOLDER})
  file(GLOB_RECURSE files RELATIVE ${folder} ${folder}/*.h ${folder}/*.cc)
  list(FILTER files EXCLUDE REGEX "node_modules/")
  foreach(header IN LISTS ${name}_HEADERS)
    if(NOT EXISTS ${folder}/${header})
      fault("${folder}/CMakeLists.txt: HEADERS name ${header}, and there is no such file.")
    endif()
  endforeach()
  set(used "")
  foreach(file IN LISTS files)
    set(is_header FALSE)
    if(file MATCHES "\\.h$")
      set(is_header TRUE)
    endif()
    floor_of(${file} floor)
    file(STRINGS ${folder}/${file} includes REGEX "^ *# *include *\"")
    foreach(line IN LISTS includes)
      if(NOT line MATCHES "^#include \"fathom/([a-z_]+)/([a-z0-9_/]+\\.h)\"$")
        fault("${folder}/${file}: '${line}', expected #include \"fathom/<folder>/<file>.h\".")
        continue()
      endif()
      set(other ${CMAKE_MATCH_1})
      set(header ${CMAKE_MATCH_2})
      if(NOT other IN_LIST folders)
        fault("${folder}/${file}: '${line}': there is no folder ${other}.")
        continue()
      endif()
      if(NOT EXISTS ${${other}_FOLDER}/${header})
        fault("${folder}/${file}: '${line}': there is no ${${other}_FOLDER}/${header}.")
        continue()
      endif()
      if(is_header AND file IN_LIST ${name}_HEADERS AND NOT header IN_LIST ${other}_HEADERS)
        fault("${folder}/${file} is one of HEADERS and includes ${header}: "
              "add ${header} to HEADERS in ${${other}_FOLDER}/CMakeLists.txt.")
      endif()
      if(other STREQUAL name)
        floor_of(${header} below)
        list(FIND ${name}_FLOORS "${floor}" own_place)
        list(FIND ${name}_FLOORS "${below}" place)
        if(NOT floor STREQUAL "" AND place GREATER own_place)
          fault("${folder}/${file} includes ${header}, and ${below} stands above ${floor} in the "
                "FLOORS of ${folder}/CMakeLists.txt.")
        endif()
        continue()
      endif()
      list(APPEND used fathom::${other})
      if(is_header)
        set(allowed ${${name}_DEPENDS})
        set(where DEPENDS)
      else()
        set(allowed ${${name}_DEPENDS} ${${name}_PRIVATE_DEPENDS})
        set(where PRIVATE_DEPENDS)
      endif()
      if(NOT fathom::${other} IN_LIST allowed)
        fault("${folder}/${file} includes \"fathom/${other}/${header}\": "
              "add fathom::${other} to ${where} in ${folder}/CMakeLists.txt.")
      endif()
      if(NOT header IN_LIST ${other}_HEADERS)
        fault("${folder}/${file} includes \"fathom/${other}/${header}\": "
              "add ${header} to HEADERS in ${${other}_FOLDER}/CMakeLists.txt, "
              "if it is for others.")
      endif()
    endforeach()
  endforeach()
  foreach(target IN LISTS ${name}_DEPENDS ${name}_PRIVATE_DEPENDS)
    if(target MATCHES "^fathom::" AND NOT target IN_LIST used)
      fault("${folder}/CMakeLists.txt names ${target}, which no file includes: take it out.")
    endif()
  endforeach()
endforeach()
if(num_faults GREATER 0)
  message(FATAL_ERROR "Includes and CMakeLists.txt do not agree in ${num_faults} places.")
endif()
