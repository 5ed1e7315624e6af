# Fails if a file of FOLDER can include a header of one of the folders ABOVE it, or cannot include
# its own. Run with cmake -P; the variables are set in CMakeLists.txt.

cmake_minimum_required(VERSION 3.22)
list(REMOVE_ITEM INCLUDE_DIRS "")
list(TRANSFORM INCLUDE_DIRS PREPEND -I)
file(MAKE_DIRECTORY ${SCRATCH})

# Sets `found` to whether a file of FOLDER that includes one header of the folder `name` gets past
# the preprocessor. Anything else that goes wrong is an error.
function(can_include name found)
  set(folders ${ORDER})
  list(FILTER folders INCLUDE REGEX "/${name}$")
  file(GLOB headers RELATIVE ${SOURCE_DIR}/${folders} ${SOURCE_DIR}/${folders}/*.h)
  if(headers STREQUAL "")
    set(${found} NOTHING_THERE PARENT_SCOPE)
    return()
  endif()
  list(GET headers 0 header)
  file(WRITE ${SCRATCH}/includes_${name}.cc "#include \"fathom/${name}/${header}\"\n")
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -E -o ${SCRATCH}/includes_${name}.ii ${INCLUDE_DIRS}
            ${SCRATCH}/includes_${name}.cc
    RESULT_VARIABLE result ERROR_VARIABLE messages)
  if(result EQUAL 0)
    set(${found} TRUE PARENT_SCOPE)
  elseif(messages MATCHES "includes_${name}.cc:1:10: fatal error: '?fathom/${name}/${header}")
    set(${found} FALSE PARENT_SCOPE)
  else()
    message(FATAL_ERROR "${messages}")
  endif()
endfunction()

get_filename_component(own ${FOLDER} NAME)
can_include(${own} found)
if(NOT found STREQUAL "TRUE")
  message(SEND_ERROR "A file of ${FOLDER} cannot include a header of its own folder.")
endif()
foreach(name IN LISTS ABOVE)
  can_include(${name} found)
  if(found STREQUAL "TRUE")
    message(SEND_ERROR "A file of ${FOLDER} can include fathom/${name}/, which it must not know: "
                       "take fathom::${name} out of ${FOLDER}/CMakeLists.txt.")
  endif()
endforeach()
