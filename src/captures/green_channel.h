// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

// The green channel of a BGR picture (CV_8UC3), in which the stripes are read (§3.4), as CV_8UC1.
cv::Mat GreenChannel(const cv::Mat& bgr);

}  // namespace dorsum
