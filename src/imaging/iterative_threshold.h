// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

// Threshold between two groups of grey values by the iterative algorithm of §2.2, a case of 2-means
// clustering (Ridler and Calvard 1978): starting from the mean, it becomes the middle of the two groups'
// means until it stays. `image` is CV_8UC1, not empty. A value above the threshold belongs to the object.
double IterativeThreshold(const cv::Mat& image);

}  // namespace dorsum
