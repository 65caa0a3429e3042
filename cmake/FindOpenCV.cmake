# SPDX-License-Identifier: Apache-2.0
# OpenCV's own CMake package where there is one. Debian puts that into libopencv-dev, which drags in every
# module there is; its small libopencv-<module>-dev packages bring headers and libraries only, and for those
# this file defines the same targets: opencv_core, opencv_imgproc ...
find_package(OpenCV ${OpenCV_FIND_VERSION} CONFIG QUIET COMPONENTS ${OpenCV_FIND_COMPONENTS})
if(OpenCV_FOUND)
  return()
endif()

find_path(OpenCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
mark_as_advanced(OpenCV_INCLUDE_DIR)
set(_opencv_version_file "${OpenCV_INCLUDE_DIR}/opencv2/core/version.hpp")
if(OpenCV_INCLUDE_DIR AND EXISTS "${_opencv_version_file}")
  set(_opencv_parts)
  foreach(part MAJOR MINOR REVISION)
    file(STRINGS "${_opencv_version_file}" _opencv_line REGEX "^#define CV_VERSION_${part} ")
    string(REGEX MATCH "[0-9]+$" _opencv_line "${_opencv_line}")
    list(APPEND _opencv_parts "${_opencv_line}")
  endforeach()
  list(JOIN _opencv_parts "." OpenCV_VERSION)
endif()

foreach(component IN LISTS OpenCV_FIND_COMPONENTS)
  find_library(OpenCV_${component}_LIBRARY opencv_${component})
  mark_as_advanced(OpenCV_${component}_LIBRARY)
  find_path(OpenCV_${component}_HEADER_DIR opencv2/${component}.hpp HINTS "${OpenCV_INCLUDE_DIR}")
  mark_as_advanced(OpenCV_${component}_HEADER_DIR)
  if(OpenCV_${component}_LIBRARY AND OpenCV_${component}_HEADER_DIR)
    set(OpenCV_${component}_FOUND TRUE)
  endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCV
  REQUIRED_VARS OpenCV_INCLUDE_DIR
  VERSION_VAR OpenCV_VERSION
  HANDLE_COMPONENTS)

if(OpenCV_FOUND)
  foreach(component IN LISTS OpenCV_FIND_COMPONENTS)
    if(NOT TARGET opencv_${component})
      add_library(opencv_${component} UNKNOWN IMPORTED)
      set_target_properties(opencv_${component} PROPERTIES
        IMPORTED_LOCATION "${OpenCV_${component}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${OpenCV_INCLUDE_DIR}")
      if(NOT component STREQUAL "core")
        set_property(TARGET opencv_${component} PROPERTY INTERFACE_LINK_LIBRARIES opencv_core)
      endif()
    endif()
  endforeach()
endif()
