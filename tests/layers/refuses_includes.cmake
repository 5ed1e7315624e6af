# check_includes.cmake refuses what two small folders do wrong, and says which line to change. Run
# with cmake -P.

cmake_minimum_required(VERSION 3.22)

# Expects `message` of folders a and b, b above a, where b/b.h includes `header` of a, and b declares
# `depends`. Without a message: no complaint.
function(expect message header depends)
  file(REMOVE_RECURSE ${SCRATCH})
  file(WRITE ${SCRATCH}/src/fathom/a/a.h "#pragma once\n")
  file(WRITE ${SCRATCH}/src/fathom/a/own.h "#pragma once\n")
  file(WRITE ${SCRATCH}/src/fathom/b/b.h "#include ${header}\n")
  file(WRITE ${SCRATCH}/src/fathom/b/low/low.h "#pragma once\n${ARGN}\n")
  file(WRITE ${SCRATCH}/src/fathom/b/high/high.h "#pragma once\n")
  file(WRITE ${SCRATCH}/folders.cmake
    "set(folders a b)\nset(a_FOLDER ${SCRATCH}/src/fathom/a)\nset(a_HEADERS a.h)\n"
    "set(b_FOLDER ${SCRATCH}/src/fathom/b)\nset(b_DEPENDS ${depends})\nset(b_FLOORS low high)\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DFOLDERS=${SCRATCH}/folders.cmake -P ${CHECK}
                  RESULT_VARIABLE result ERROR_VARIABLE messages)
  string(REGEX REPLACE "[ \n]+" " " messages "${messages}")
  if(message STREQUAL "")
    if(NOT result EQUAL 0)
      message(SEND_ERROR "Expected no complaint, got: ${messages}")
    endif()
    return()
  endif()
  string(FIND "${messages}" "${message}" place)
  if(result EQUAL 0 OR place EQUAL -1)
    message(SEND_ERROR "Expected '${message}', got: ${messages}")
  endif()
endfunction()

expect("" "\"fathom/a/a.h\"" "fathom::a")
expect("add fathom::a to DEPENDS in ${SCRATCH}/src/fathom/b/CMakeLists.txt" "\"fathom/a/a.h\"" "")
expect("names fathom::a, which no file includes" "<vector>" "fathom::a")
expect("add own.h to HEADERS in ${SCRATCH}/src/fathom/a/CMakeLists.txt" "\"fathom/a/own.h\""
       "fathom::a")
expect("expected #include \"fathom/<folder>/<file>.h\"" "\"a.h\"" "")
expect("there is no ${SCRATCH}/src/fathom/a/no.h" "\"fathom/a/no.h\"" "fathom::a")
expect("and high stands above low in the FLOORS" "<vector>" ""
       "#include \"fathom/b/high/high.h\"")
