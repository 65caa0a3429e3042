# SPDX-License-Identifier: Apache-2.0
# cairo ships no CMake package. Defines Cairo::cairo, with the PDF surface.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(Cairo_PC QUIET cairo-pdf)
endif()
find_path(Cairo_INCLUDE_DIR cairo-pdf.h HINTS ${Cairo_PC_INCLUDE_DIRS} PATH_SUFFIXES cairo)
find_library(Cairo_LIBRARY cairo HINTS ${Cairo_PC_LIBRARY_DIRS})
mark_as_advanced(Cairo_INCLUDE_DIR Cairo_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Cairo
  REQUIRED_VARS Cairo_LIBRARY Cairo_INCLUDE_DIR
  VERSION_VAR Cairo_PC_VERSION)

if(Cairo_FOUND AND NOT TARGET Cairo::cairo)
  add_library(Cairo::cairo UNKNOWN IMPORTED)
  set_target_properties(Cairo::cairo PROPERTIES
    IMPORTED_LOCATION "${Cairo_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Cairo_INCLUDE_DIR}")
endif()
