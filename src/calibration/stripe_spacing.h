// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "calibration/line_finder.h"
#include "calibration/rectification.h"
#include "captures/calibration_series.h"
#include "captures/names.h"
#include "imaging/stripe_mask.h"

namespace dorsum {

struct StripeSpacingOptions {
  double band_mm = 30.0;  // half-height of the strip of the plane in which stripes are taken as straight, mm
  StripeMaskOptions mask;
  LineFinderOptions lines;
};

// The stripes of one laser on one plane of the series, as straight lines in the rectified image.
struct PlaneStripes {
  Rectification rectification;
  std::vector<double> x_mm;        // position of each line at the board centre's height, mm, growing
  std::vector<double> brightness;  // of each line, grey values
  std::vector<int> index;          // counted from the leftmost, with gaps where lines are missing
  int central = -1;                // the brightest line
  cv::Mat picture;                 // rectified strip with lines and distances drawn (Figure 4.1), BGR
};

// Observes one laser at one distance (§3.2 "Calibration images preprocessing", "Grating position
// estimation"): homography from the …Chess image, inverse perspective, background subtraction, stripe
// masking, line detection. `known_corners`: those of the …Chess image, if they were found before; `dark`: the
// distance's …Bg image (BGR), if it was read before.
Result<PlaneStripes> ObserveStripes(const CalibrationSeries& series, const Camera& camera, int laser,
                                    Distance distance, const StripeSpacingOptions& options,
                                    const Context& context,
                                    const std::vector<cv::Point2f>* known_corners = nullptr,
                                    cv::Mat dark = {});

// Mean distance between neighbouring stripes, mm, over orders from..to counted from the central stripe.
double MeanSpacing(const PlaneStripes& stripes, int from, int to);

}  // namespace dorsum
