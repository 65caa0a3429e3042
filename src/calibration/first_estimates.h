// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "calibration/line_finder.h"
#include "captures/calibration_series.h"
#include "geometry/camera.h"

namespace dorsum {

struct FirstEstimatesOptions {
  LineFinderOptions lines{
      .max_tilt_deg = 20.0, .min_length_share = 0.25, .max_gap_px = 12.0, .merge_px = 12.0};
};

// The dark lines that are drawn on the laser calibration plane (§3.2), found in laserFirstEstimates against
// bgNoHand: their world x (mm) on the backplane at y = 0, growing.
Result<std::vector<double>> FindFirstEstimates(const CalibrationSeries& series, const Camera& camera,
                                               const FirstEstimatesOptions& options, const Context& context);

// Gives each laser its line: the one at its brightest stripe, the closest pairs first, so that a laser whose
// brightest stripe is not its central one gets the line that is left. Lasers that lean may cross. `brightest`
// maps laser to world x, mm. Empty when the counts differ.
std::map<int, double> AssignFirstEstimates(const std::vector<double>& lines,
                                           const std::map<int, double>& brightest);

}  // namespace dorsum
