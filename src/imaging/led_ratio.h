// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

// Square root of the light of the hand's picture over that of the background's, green channels (of pictures
// in colour, or alone), CV_32FC1,
// lightly smoothed; the root, so that steps in deep shadow and in full light compare, as their noise does.
// 1 where nothing changed; a shadow multiplies it smoothly, an object's outline is a sharp step. `scale` 2
// halves the size (rounded up): pixel (i, j) is then the mean of four, around (2 i + 0.5, 2 j + 0.5).
cv::Mat LedRatio(const cv::Mat& background, const cv::Mat& hand, int scale, const Context& context = {});

}  // namespace dorsum
