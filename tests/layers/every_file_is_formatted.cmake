# Fails if clang-format would change a file. Run with cmake -P.

cmake_minimum_required(VERSION 3.22)
foreach(folder IN ITEMS src problems tools python tests bench fuzz)
  file(GLOB_RECURSE found ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cc)
  list(APPEND files ${found})
endforeach()
list(FILTER files EXCLUDE REGEX "/node_modules/")
execute_process(COMMAND ${CLANG_FORMAT} --style=file --dry-run --Werror ${files}
                RESULT_VARIABLE result ERROR_VARIABLE messages)
if(NOT result EQUAL 0)
  string(REGEX MATCHALL "[^\n]*: error:" places "${messages}")
  list(TRANSFORM places REPLACE ":[0-9]+:[0-9]+: error:$" "")
  list(REMOVE_DUPLICATES places)
  list(JOIN places "\n  " places)
  message(FATAL_ERROR "Not as .clang-format says; run clang-format -i on\n  ${places}")
endif()
