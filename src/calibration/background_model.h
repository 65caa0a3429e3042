// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "geometry/calibration.h"
#include "imaging/stripe_mask.h"
#include "stripes/classic_indexing.h"
#include "stripes/classic_segments.h"
#include "stripes/smoothing.h"

namespace dorsum {

struct BackgroundModelOptions {
  StripeMaskOptions mask;
  ClassicSegmentOptions segments;
  SmoothingOptions smoothing;
  ClassicIndexingOptions indexing;
  int min_points = 150;  // fewest points of a stripe to fit a line to
};

// A line fitted to one whole background stripe: x = at + slope * y on the backplane, world, mm.
struct BackgroundLine {
  int order = 0;
  double at = 0.0, slope = 0.0;
  double rms_mm = 0.0;  // bow that the line leaves out
  int points = 0;
};

struct BackgroundModel {
  LaserStripes stripes;                    // indexed, as in the picture of Figure 5.2(a)
  std::vector<BackgroundLine> lines;       // by growing order
  std::vector<ReferenceStripe> reference;  // the same stripes as curves in the image
};

// Reference stripes of the background (§3.2, §3.4): the stripes of stripesBgK, counted from the central one,
// which is the stripe nearest to `central_x_mm` at y = 0; and a line on the backplane for each (§3.6).
// `line_x_mm` are the stripes' positions at y = 0 as already measured (growing), which give the usual
// spacing.
Result<BackgroundModel> ModelBackground(const cv::Mat& image, int laser, const Camera& camera,
                                        double central_x_mm, const std::vector<double>& line_x_mm,
                                        const BackgroundModelOptions& options, const Context& context);

// The document's sheets (§3.6): a plane through the grating point and each background line. Lines of orders
// that are missing between others are interpolated.
std::vector<PlaneSheet> PlanesThroughGrating(const Eigen::Vector3d& grating,
                                             const std::vector<BackgroundLine>& lines);

}  // namespace dorsum
