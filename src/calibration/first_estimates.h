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

// The lines of laserFirstEstimates as they are seen, nearly vertical, by growing column.
struct DrawnLines {
  std::vector<VerticalLine> lines;  // px
  int rows = 0;                     // of the picture
};

// Looks for the drawn lines of §3.2 ("Laser central stripes"), dark on the backplane. An error when there are
// none.
Result<DrawnLines> FindDrawnLines(const CalibrationSeries& series, const FirstEstimatesOptions& options,
                                  const Context& context);

// Where they cross y = 0 on the backplane: world x, mm, ascending.
std::vector<double> PlacesOfLines(const DrawnLines& drawn, const Camera& camera);

// Gives each laser its line: the one at its brightest stripe, the closest pairs first, so that a laser whose
// brightest stripe is not its central one gets the line that is left. Lasers that lean may cross. `brightest`
// maps laser to world x, mm. Empty when the counts differ.
std::map<int, double> AssignFirstEstimates(const std::vector<double>& lines,
                                           const std::map<int, double>& brightest);

}  // namespace dorsum
