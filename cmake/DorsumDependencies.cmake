# SPDX-License-Identifier: Apache-2.0
# Every library that an installed layer links. Read by this build and by the installed package alike, so that
# the two cannot disagree: the package defines dorsum_find() as find_dependency().
if(NOT COMMAND dorsum_find)
  macro(dorsum_find)
    find_package(${ARGN} REQUIRED)
  endmacro()
endif()

dorsum_find(Threads)
dorsum_find(ZLIB)
dorsum_find(JPEG)
dorsum_find(PNG)
dorsum_find(TIFF)
dorsum_find(TBB CONFIG)
dorsum_find(Eigen3 3.4 CONFIG)
dorsum_find(nlohmann_json 3.11 CONFIG)
dorsum_find(tomlplusplus CONFIG)
dorsum_find(Sodium)
dorsum_find(SerialPort)
dorsum_find(Cairo)
dorsum_find(OpenCV 4 COMPONENTS core imgproc calib3d)
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)  # Ceres' search for SuiteSparse does not heed QUIET
dorsum_find(Ceres 2.1 CONFIG QUIET)
unset(CMAKE_MESSAGE_LOG_LEVEL)
dorsum_find(embree 3 CONFIG)
dorsum_find(assimp 5 CONFIG)
dorsum_find(hwy 1 CONFIG)
