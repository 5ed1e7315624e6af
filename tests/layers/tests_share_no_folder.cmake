# Tests run side by side: what they write lies in the folder that test_folder.h names after each.
cmake_policy(VERSION 3.22)

file(GLOB_RECURSE files ${SOURCE_DIR}/tests/*.h ${SOURCE_DIR}/tests/*.cc)
list(REMOVE_ITEM files ${SOURCE_DIR}/tests/test_folder.h)
foreach(file IN LISTS files)
  file(STRINGS ${file} uses REGEX "FATHOM_SCRATCH_DIR|TempDir\\(")
  if(uses)
    message(SEND_ERROR "${file}: use TestFolder() or EmptyTestFolder() in place of: ${uses}")
  endif()
endforeach()
