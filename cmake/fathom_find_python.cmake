# FATHOM_PYTHON: whether the Python module is built. ON where pybind11 and Python's headers are found,
# quietly OFF elsewhere. It uses what the tools share.
#
# Python is the active virtual environment's, else the system's: another python3 on the PATH, as a
# shim of pyenv, may have neither headers nor NumPy. -DPython_EXECUTABLE=... names another one.
if(NOT DEFINED Python_EXECUTABLE AND FATHOM_BUILD_TOOLS)
  if(DEFINED ENV{VIRTUAL_ENV})
    set(Python_EXECUTABLE $ENV{VIRTUAL_ENV}/bin/python CACHE FILEPATH "Python of the module")
  elseif(EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python of the module")
  endif()
endif()
if(FATHOM_BUILD_TOOLS AND (NOT DEFINED FATHOM_PYTHON OR FATHOM_PYTHON))
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()
set(is_python_found OFF)
if(Python_Development.Module_FOUND AND pybind11_FOUND)
  set(is_python_found ON)
endif()
option(FATHOM_PYTHON "Build the Python module" ${is_python_found})
if(FATHOM_PYTHON AND NOT is_python_found)
  message(FATAL_ERROR "FATHOM_PYTHON: needs the tools (FATHOM_BUILD_TOOLS), pybind11 and the headers of "
                      "Python: apt-get install pybind11-dev python3-dev.")
endif()
