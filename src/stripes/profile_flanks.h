// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "stripes/stripes.h"

namespace dorsum {

// Where the averaged profile's peak is, from the points' own column, and how far from it the profile has
// fallen to half, px.
struct ProfileFlanks {
  double peak = 0.0, left = 0.0, right = 0.0;
};

// The flanks of every point of one segment, by growing row: profiles are averaged over `half_rows` rows to
// either side, each shifted to its own point's column, so that speckle does not feign a steep flank. `green`
// is CV_8UC1.
std::vector<ProfileFlanks> FlanksAlong(const cv::Mat& green, const std::vector<StripePoint>& points,
                                       int half_rows);

}  // namespace dorsum
