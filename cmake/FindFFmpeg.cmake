# Single libraries of FFmpeg, which brings no CMake files of its own:
#
#   find_package(FFmpeg REQUIRED COMPONENTS avformat avcodec)
#   target_link_libraries(x PRIVATE FFmpeg::avformat FFmpeg::avcodec)

set(FFmpeg_required)
foreach(component IN LISTS FFmpeg_FIND_COMPONENTS)
  find_path(FFmpeg_${component}_INCLUDE_DIR lib${component}/${component}.h)
  find_library(FFmpeg_${component}_LIBRARY ${component})
  mark_as_advanced(FFmpeg_${component}_INCLUDE_DIR FFmpeg_${component}_LIBRARY)
  list(APPEND FFmpeg_required FFmpeg_${component}_LIBRARY FFmpeg_${component}_INCLUDE_DIR)
  if(FFmpeg_${component}_LIBRARY AND FFmpeg_${component}_INCLUDE_DIR)
    set(FFmpeg_${component}_FOUND TRUE)
  endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FFmpeg
  REQUIRED_VARS ${FFmpeg_required} HANDLE_COMPONENTS)

if(FFmpeg_FOUND)
  foreach(component IN LISTS FFmpeg_FIND_COMPONENTS)
    if(NOT TARGET FFmpeg::${component})
      add_library(FFmpeg::${component} UNKNOWN IMPORTED)
      set_target_properties(FFmpeg::${component} PROPERTIES
        IMPORTED_LOCATION ${FFmpeg_${component}_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${FFmpeg_${component}_INCLUDE_DIR})
    endif()
  endforeach()
endif()
