# Writes the commit of the checkout SOURCE_DIR into the C++ file FILE, which stays untouched where it
# says that already:
#
#   cmake -DSOURCE_DIR=... -DFILE=commit.cc -P cmake/write_commit.cmake
cmake_policy(VERSION 3.22)
set(commit "unknown")
find_program(GIT git)
# Sources that were unpacked inside another repository are not of its commit.
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${GIT} -C ${SOURCE_DIR} describe --always --exclude=* --abbrev=7 "--dirty= with changes"
    OUTPUT_VARIABLE described RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(failed EQUAL 0 AND described MATCHES "^[0-9a-f]+( with changes)?$")
    set(commit "${described}")
  endif()
endif()
file(CONFIGURE OUTPUT ${FILE} @ONLY CONTENT [[
// Written by cmake/write_commit.cmake.

namespace fathom {

extern const char kCommit[];
const char kCommit[] = "@commit@";

}  // namespace fathom
]])
