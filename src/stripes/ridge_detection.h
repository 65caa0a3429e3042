// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "stripes/noise_model.h"

namespace dorsum {

// A place in an image row where a stripe seems to cross it.
struct RidgeCandidate {
  float u = 0.0F;         // px
  float response = 0.0F;  // of the matched filter: about the profile's amplitude, grey values
};

struct RidgeDetectionOptions {
  double width_px = 2.0;      // of the profile looked for, one standard deviation, 0.7 to 8
  double min_contrast = 4.5;  // least response in standard deviations of its noise, 2 to 20
  double min_response = 1.5;  // least response, grey values, 0 to 255
  // Least response as a share of the strongest within four widths and 8 px, 0 to 1: compression
  // leaves ripples beside a bright stripe.
  double min_share = 0.05;
};

// The rows first, first + step, …
struct RowComb {
  int first = 0, step = 1;
  bool Has(int row) const { return row >= first && (row - first) % step == 0; }
};

// Candidates of every row, by growing u. The image is smoothed over the rows beside it, so that a dim stripe
// gathers evidence, and filtered along the row for a stripe's profile on an even background (ridge_kernel.h);
// the local maxima above the noise are the candidates, at the top of the parabola through the three values.
// Where two stand closer than two widths without a dip between them, the stronger stays. `green` is CV_8UC1;
// `region` CV_8UC1 or empty. Looks at the rows of `comb` only; the others have no candidates.
std::vector<std::vector<RidgeCandidate>> DetectRidges(const cv::Mat& green, const cv::Mat& region,
                                                      const NoiseModel& noise,
                                                      const RidgeDetectionOptions& options,
                                                      const Context& context, const RowComb& comb = {});

}  // namespace dorsum
