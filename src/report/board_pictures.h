// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "geometry/camera.h"

namespace dorsum {

// Where a calibrated camera would see the corners of the first board, which lies on the backplane: the grid
// of squares is laid through the corners as they were seen and projected. In the corners' order; empty when
// the corners are not `inner.area()` in number.
std::vector<cv::Point2f> ReprojectBoard(const Camera& camera, const std::vector<cv::Point2f>& corners,
                                        cv::Size inner, double square_mm);

// Seen corners as rings on the photo, with arrows to where the model expects them, drawn many times longer.
// Without expected places: the rings alone.
cv::Mat DrawReprojection(const cv::Mat& photo, const std::vector<cv::Point2f>& seen,
                         const std::vector<cv::Point2f>& expected, int width_px = 1200);

// All corners of all views in the frame of the image, one colour per view: places without corners are places
// where the lens is only guessed.
cv::Mat DrawCornerCoverage(cv::Size image, const std::vector<std::vector<cv::Point2f>>& views,
                           int width_px = 1200);

}  // namespace dorsum
