# The packages for Debian: `cpack` in a build of preset package, or scripts/package.sh. docs/packages.md.
#
#   fathom-uuv         the programs, completions, man pages, data     components tools and share
#   libfathom-uuv-dev  static libraries, headers, CMake's files       component development
#   python3-fathom     the Python module                              component python
#
# Debian has a package fathom, and a libfathom-dev, of another program (Syzygy tables of chess), with a higher
# version: apt would put them in the place of ours.
set(fathom_package_of_programs fathom-uuv)
set(fathom_package_of_development libfathom-uuv-dev)
set(fathom_package_of_python python3-fathom)

# Who answers for the packages, as Debian's own tools ask for it.
set(CPACK_PACKAGE_CONTACT "The Fathom authors <fathom@example.org>")
if(DEFINED ENV{DEBEMAIL})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # The first line of each description is its own.
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
# CMake strips programs and shared libraries, but not static ones.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/strip_static_libraries.cmake)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL tools share development)
if(FATHOM_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME ${fathom_package_of_programs})
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS gnuplot-nox)  # figures for print
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "motion models of underwater vehicles from their logs
Fathom identifies motion models of underwater vehicles from their logs:
inertia, damping and buoyancy, each with a confidence interval. It says what
a model gets wrong and names the cause where the data allow only one answer.")

# The libraries are static: who links them links these too.
file(STRINGS scripts/apt-packages.txt lines)
list(FIND lines "# The libraries." first)
set(libraries "")
while(TRUE)
  math(EXPR first "${first} + 1")
  list(GET lines ${first} line)
  if(NOT line MATCHES "^#" AND NOT line MATCHES "-dev$")
    break()
  elseif(line MATCHES "-dev$")
    list(APPEND libraries ${line})
  endif()
endwhile()
list(JOIN libraries ", " libraries)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME ${fathom_package_of_development})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${libraries}")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "motion models of underwater vehicles (development files)
Static libraries, headers and CMake package files of Fathom, which identifies
motion models of underwater vehicles from their logs.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME ${fathom_package_of_python})
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# The module is built for one version of Python.
if(FATHOM_PYTHON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "motion models of underwater vehicles from their logs (Python)
The Python module of Fathom, which identifies motion models of underwater
vehicles from their logs.")

# Each package says whose it is and what is new.
string(TIMESTAMP fathom_date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH, if it is set
foreach(pair IN ITEMS programs=share development=development python=python)
  string(REGEX MATCH "(.*)=(.*)" pair ${pair})
  set(component ${CMAKE_MATCH_2})
  set(package ${fathom_package_of_${CMAKE_MATCH_1}})
  set(folder ${PROJECT_BINARY_DIR}/packaging/${package})
  configure_file(packaging/changelog.in ${folder}/changelog.Debian @ONLY)
  configure_file(CHANGELOG.md ${folder}/changelog COPYONLY)
  execute_process(COMMAND gzip -9nkf ${folder}/changelog ${folder}/changelog.Debian
                  COMMAND_ERROR_IS_FATAL ANY)
  install(FILES packaging/copyright ${folder}/changelog.gz ${folder}/changelog.Debian.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()
# Messages and man pages name pages of docs/.
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${fathom_package_of_programs} COMPONENT share
        FILES_MATCHING PATTERN "*.md" PATTERN images EXCLUDE)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${fathom_package_of_programs}
        COMPONENT share)

include(CPack)
cpack_add_component_group(programs)
cpack_add_component(tools GROUP programs)
cpack_add_component(share GROUP programs)
