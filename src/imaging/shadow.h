// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// Takes shadow out of a mask: the part of it that lies nearer to a place known to be backplane than to one
// known to be object (both in pixels). Only places inside the mask count. Without any backplane place the
// mask stays as it is. What is left of the mask in pieces of less than `min_area_share` of the image goes
// too.
cv::Mat RemoveShadow(const cv::Mat& mask, const std::vector<cv::Point>& object,
                     const std::vector<cv::Point>& backplane, double min_area_share = 0.0005);

}  // namespace dorsum
