// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

constexpr int kMaxBorderReach = 181;  // twice its square fits into 16 bits

// Squared distance, px^2, from the centre of each pixel of `region` (CV_8UC1) that is set to the nearest one
// that is not, at most reach^2; 0 where a pixel is not set. What lies beyond the picture is not known and
// counts as set. Exact (Saito & Toriwaki 1994: along columns, then across). `reach`: 1 to kMaxBorderReach.
cv::Mat1w SquaredBorderDistance(const cv::Mat& region, int reach);

}  // namespace dorsum
