# Fails if a file of the library includes a file by a path that goes around the include directories
# of its target: #include "log.h", #include "../log/log.h". Run with cmake -P.

cmake_minimum_required(VERSION 3.22)
file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR}
  ${SOURCE_DIR}/src/*.h ${SOURCE_DIR}/src/*.cc
  ${SOURCE_DIR}/problems/*.h ${SOURCE_DIR}/problems/*.cc
  ${SOURCE_DIR}/tools/*.h ${SOURCE_DIR}/tools/*.cc)
list(FILTER files EXCLUDE REGEX "/node_modules/")
if(files STREQUAL "")
  message(FATAL_ERROR "There are no files in ${SOURCE_DIR}.")
endif()
foreach(file IN LISTS files)
  file(STRINGS ${SOURCE_DIR}/${file} includes REGEX "^ *# *include *\"")
  foreach(line IN LISTS includes)
    if(NOT line MATCHES "^#include \"fathom/[a-z_]+/[a-z_/]+\\.h\"$")
      message(SEND_ERROR "${file}: '${line}', expected #include \"fathom/<folder>/<file>.h\".")
    endif()
  endforeach()
endforeach()
