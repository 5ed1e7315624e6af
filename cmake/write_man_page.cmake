# Writes the man page of a program from its --help, compressed:
#
#   cmake -DPROGRAM=.../fathom_check -DPAGE=.../fathom_check.1.gz -DVERSION=0.1.0 -DHELP2MAN=help2man
#         -DGZIP=gzip -P cmake/write_man_page.cmake
#
# The line below NAME is the first sentence of the help. SOURCE_DATE_EPOCH fixes the date.
cmake_policy(VERSION 3.22)
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[.]?[ ]*\n.*" "" sentence "${help}")
string(REGEX REPLACE "[.] [A-Z].*" "" sentence "${sentence}")
string(REGEX REPLACE "[.]gz$" "" plain ${PAGE})
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8
          ${HELP2MAN} --no-info "--name=${sentence}" --version-string=${VERSION} --output=${plain} ${PROGRAM}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${GZIP} -9nf ${plain} COMMAND_ERROR_IS_FATAL ANY)
