# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` adds to the layers and programs: the CMake package, the documents and the licence.
include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/Dorsum")
get_property(DORSUM_INSTALLED_LAYERS GLOBAL PROPERTY DORSUM_INSTALLED_LAYERS)

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/DorsumConfig.cmake.in" "${PROJECT_BINARY_DIR}/DorsumConfig.cmake"
  INSTALL_DESTINATION "${package_folder}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/DorsumConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)

install(FILES
  "${PROJECT_BINARY_DIR}/DorsumConfig.cmake"
  "${PROJECT_BINARY_DIR}/DorsumConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/DorsumDependencies.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindCairo.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindOpenCV.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindSerialPort.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindSodium.cmake"
  DESTINATION "${package_folder}")
if(DORSUM_INSTALLED_LAYERS)
  install(EXPORT DorsumTargets NAMESPACE Dorsum:: DESTINATION "${package_folder}")
endif()

install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
file(GLOB documents CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md")
install(FILES ${documents} DESTINATION "${CMAKE_INSTALL_DOCDIR}")
