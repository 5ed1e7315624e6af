# Fails if a header of HEADER_DIR needs an include directory that a user of its target does not
# have, or brings in a library that belongs into .cc files. HEAVY_HEADERS may, unless they are among
# PUBLIC_HEADERS. Run with cmake -P.

cmake_minimum_required(VERSION 3.22)
set(heavy ceres opencv2 opencv4 yaml-cpp nlohmann fmt glog gflags csv.h apriltag turbojpeg.h)

list(REMOVE_ITEM INCLUDE_DIRS "")
list(TRANSFORM INCLUDE_DIRS PREPEND -I)
file(MAKE_DIRECTORY ${SCRATCH})
file(GLOB_RECURSE headers RELATIVE ${HEADER_DIR} ${HEADER_DIR}/*.h)
list(FILTER headers EXCLUDE REGEX "node_modules/")
if(headers STREQUAL "")
  message(FATAL_ERROR "${HEADER_DIR} has no headers.")
endif()
foreach(header IN LISTS headers)
  file(WRITE ${SCRATCH}/alone.cc "#include \"fathom/${NAME}/${header}\"\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 -M ${INCLUDE_DIRS} ${SCRATCH}/alone.cc
                  RESULT_VARIABLE result OUTPUT_VARIABLE files ERROR_VARIABLE messages)
  if(NOT result EQUAL 0)
    message(SEND_ERROR "fathom/${NAME}/${header} finds not all it includes:\n${messages}")
    continue()
  endif()
  if("${NAME}/${header}" IN_LIST HEAVY_HEADERS AND NOT header IN_LIST PUBLIC_HEADERS)
    continue()
  endif()
  foreach(library IN LISTS heavy)
    if(files MATCHES "/include/${library}[/ \n]")
      message(SEND_ERROR "fathom/${NAME}/${header} brings in ${library}: "
                         "move what needs it into the .cc file.")
    endif()
  endforeach()
endforeach()
