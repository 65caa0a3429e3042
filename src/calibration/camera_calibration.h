// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "calibration/verdict.h"
#include "captures/calibration_series.h"
#include "geometry/camera.h"

namespace dorsum {

struct CameraCalibrationOptions {
  int min_views = 4;             // fewest views with a board, 3 to 100
  double good_rms_px = 0.35;     // reprojection error up to which the camera is good
  double doubtful_rms_px = 1.0;  // and up to which it is merely doubtful
  double min_turn = 0.1;         // least tilt between the two boards that differ most, rad, 0 to 1
};

struct CameraCalibration {
  Camera camera;  // camera_from_world: z = 0 is the first board's plane, origin its centre, x along its rows,
                  // z towards the camera
  std::vector<std::string> views;  // those with a board
  std::vector<double> view_rms_px;
  std::vector<std::vector<cv::Point2f>> corners;
  // Of boards in other pictures of the series, by name, as far as they were looked for.
  std::map<std::string, std::vector<cv::Point2f>> corners_of;
  std::vector<std::string> warnings;
  PartReport report;
};

// Camera calibration of §3.2 by Zhang's method as OpenCV has it: all chessboard views of the series, the
// extrinsics of the first one (CamCalibrator, §4.4). The origin is moved to the board's centre (3.1, 3.2).
Result<CameraCalibration> CalibrateCamera(const CalibrationSeries& series,
                                          const CameraCalibrationOptions& options, const Context& context);

// The same camera after the world is turned about z by `angle` (rad) and moved so that `origin` (old world,
// mm, in the backplane) becomes (0, 0, 0).
Camera MoveWorld(const Camera& camera, const Eigen::Vector3d& origin, double angle);

}  // namespace dorsum
