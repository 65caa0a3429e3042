// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace dorsum::speed {

// Steger's curvilinear detector (IEEE PAMI 20, 1998) as it is usually made of OpenCV calls: five derivatives
// of a Gaussian as float images, the Hessian's eigenvectors, and a centre wherever the second-order Taylor
// polynomial across the line has its maximum within the pixel. `green`: CV_8UC1; `width_px`: standard
// deviation of the lines' profile; `contrast`: least second derivative of a line, grey values per px^2.
std::vector<cv::Point2f> DetectSteger(const cv::Mat& green, double width_px, double contrast);

}  // namespace dorsum::speed
