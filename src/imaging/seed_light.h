// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

// What known pixels of a picture tell about the others nearby. `known` is CV_8UC1 (imaging/seed_map.h),
// `light` CV_32FC1; both results are CV_32FC1 of their size.

// How much neighbouring pixels differ where there is no outline: noise, mottle, the slope of shadows.
cv::Mat UsualTexture(const cv::Mat& light, const cv::Mat& known);

// -1 to 1: whether the light looks more like the object's (> 0) or the backplane's around there.
cv::Mat LikeObject(const cv::Mat& light, const cv::Mat& known);

}  // namespace dorsum
