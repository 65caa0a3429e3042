// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/bundle_model.h"
#include "calibration/bundle_problem.h"
#include "calibration/camera_calibration.h"
#include "captures/calibration_series.h"

namespace dorsum {

// Adds the series' chessboards to what is adjusted: the views of the camera's calibration, of which the first
// is the world, and the boards that lay where each laser was observed (§3.2). A lying board that is not seen
// whole is a warning; one that lies lower on the calibration object than on the backplane is bad input.
Status CollectBoards(const CalibrationSeries& series, const CameraCalibration& camera, const Context& context,
                     BundleData* data, std::vector<std::string>* warnings);

// Where the adjustment of camera and boards begins: each board where this camera sees it, planes as given.
BundleState StartOfBoards(const Camera& camera, const BundleData& data);

}  // namespace dorsum
