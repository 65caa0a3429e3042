// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "captures/device_description.h"
#include "report/printed_sheet.h"

namespace dorsum {

// Targets of the calibration series (§3.2), each in a frame that is seen as the camera sees it: x to the
// right (growing with the image's u), y up.

// The chessboard with a white margin of one square, as the simulator has it (simulator/board.h): the lower
// left square is black. Marks in the margin show its middle, which goes under a laser's central stripe.
PrintedSheet ChessboardTarget(const std::string& device, const BoardDesign& board);

// Where the central stripe of a laser crosses the backplane at y = 0, and its direction there.
struct CentralLine {
  int laser = 0;
  double x_mm = 0.0;
  Eigen::Vector2d direction = Eigen::Vector2d::UnitY();  // unit
};

// The plane with one line per laser, 1 mm wide. All else on it is light grey, and its rulers have no unbroken
// row of marks, so that FindDrawnLines sees nothing but the lines.
PrintedSheet FirstEstimatesTarget(const std::string& device, const std::vector<CentralLine>& lines,
                                  double length_mm);

// What stands where on the backplane, mm, in the frame of the design.
struct BackplanePlan {
  std::vector<Eigen::Vector2d> field;  // outline of what the camera sees of the backplane
  std::vector<CentralLine> lines;
  Eigen::Vector2d camera_foot = Eigen::Vector2d::Zero();  // below the camera
  struct Box {
    double height_mm = 0.0;
    Eigen::AlignedBox2d foot;
  };
  std::vector<Box> boxes;  // of known height, for the surface error correction (§3.6)
  double object_height_mm = 0.0;
  Eigen::Vector2d object_size_mm = Eigen::Vector2d::Zero();  // least size of the calibration object's top
};

// A plan to set the device up by: it does not stay on the backplane.
PrintedSheet PlanTarget(const std::string& device, const BackplanePlan& plan);

}  // namespace dorsum
