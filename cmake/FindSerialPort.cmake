# SPDX-License-Identifier: Apache-2.0
# libserialport ships no CMake package. Defines SerialPort::SerialPort.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(SerialPort_PC QUIET libserialport)
endif()
find_path(SerialPort_INCLUDE_DIR libserialport.h HINTS ${SerialPort_PC_INCLUDE_DIRS})
find_library(SerialPort_LIBRARY serialport HINTS ${SerialPort_PC_LIBRARY_DIRS})
mark_as_advanced(SerialPort_INCLUDE_DIR SerialPort_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SerialPort
  REQUIRED_VARS SerialPort_LIBRARY SerialPort_INCLUDE_DIR
  VERSION_VAR SerialPort_PC_VERSION)

if(SerialPort_FOUND AND NOT TARGET SerialPort::SerialPort)
  add_library(SerialPort::SerialPort UNKNOWN IMPORTED)
  set_target_properties(SerialPort::SerialPort PROPERTIES
    IMPORTED_LOCATION "${SerialPort_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${SerialPort_INCLUDE_DIR}")
endif()
