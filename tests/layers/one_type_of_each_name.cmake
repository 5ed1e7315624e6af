# Fails if two headers define a type of one name: all are in namespace fathom, and the linker would
# keep the destructor of one for both. Run with cmake -P.

cmake_minimum_required(VERSION 3.22)
file(GLOB_RECURSE headers RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/src/fathom/*.h
     ${SOURCE_DIR}/problems/fathom/*.h ${SOURCE_DIR}/tools/fathom/*.h)
list(FILTER headers EXCLUDE REGEX "node_modules/")
set(num_types 0)
foreach(header IN LISTS headers)
  file(STRINGS ${SOURCE_DIR}/${header} definitions
       REGEX "^(struct|class|enum class) [A-Za-z0-9_]+[^;]*{")
  foreach(line IN LISTS definitions)
    string(REGEX REPLACE "^(struct|class|enum class) ([A-Za-z0-9_]+).*" "\\2" name "${line}")
    if(DEFINED home_of_${name})
      message(SEND_ERROR "${name} is defined in ${home_of_${name}} and in ${header}.")
    endif()
    set(home_of_${name} ${header})
    math(EXPR num_types "${num_types} + 1")
  endforeach()
endforeach()
if(num_types LESS 100)
  message(FATAL_ERROR "Only ${num_types} types in ${SOURCE_DIR}.")
endif()
