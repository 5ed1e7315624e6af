# cmake -DOUTPUT=... -DSOURCES="name=file;..." -DHEADER=fathom/... -P embed.cmake
#
# Writes a .cc that defines `const std::string_view name` for each file in the namespace NAMESPACE
# (fathom::web), which HEADER declares. The bytes become
# an array of numbers: no limit on its length, no character that needs quoting.
cmake_minimum_required(VERSION 3.22)
if(NOT NAMESPACE)
  set(NAMESPACE fathom::web)
endif()
set(text "// Written by src/fathom/report/web/embed.cmake. Do not edit.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
foreach(source IN LISTS SOURCES)
  string(REPLACE "=" ";" source "${source}")
  list(GET source 0 name)
  list(GET source 1 file)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND text "static const char ${name}_bytes[] = {${bytes}};\n"
                     "const std::string_view ${name}{${name}_bytes, sizeof ${name}_bytes};\n")
endforeach()
string(APPEND text "}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUTPUT} "${text}")
