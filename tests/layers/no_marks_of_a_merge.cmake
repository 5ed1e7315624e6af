# No page, map or script holds what git leaves of two versions: compilers see to the sources.
cmake_policy(VERSION 3.22)

file(GLOB_RECURSE files
  ${SOURCE_DIR}/docs/*.md ${SOURCE_DIR}/data/*.yaml ${SOURCE_DIR}/scripts/*.sh ${SOURCE_DIR}/*.md)
list(FILTER files EXCLUDE REGEX "node_modules|^${SOURCE_DIR}/build/")
foreach(file IN LISTS files)
  file(STRINGS ${file} marks REGEX "^(<<<<<<<|>>>>>>>) ")
  if(marks)
    file(RELATIVE_PATH name ${SOURCE_DIR} ${file})
    message(SEND_ERROR "${name} holds the marks of a merge: ${marks}")
  endif()
endforeach()
