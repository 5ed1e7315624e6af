# Takes the debug information out of static libraries that CPack is about to pack, as Debian's dh_strip does.
file(GLOB_RECURSE libraries ${CPACK_TEMPORARY_DIRECTORY}/*.a)
foreach(library IN LISTS libraries)
  execute_process(COMMAND strip --strip-debug --enable-deterministic-archives ${library}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
