// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// Corners of a chessboard in a green channel (CV_8UC1), row by row, refined below a pixel (OpenCV); none
// when the board is not seen whole. `inner` is the number of inner corners. The first corner is the one at
// the image's top left, so that the boards of a series agree.
std::optional<std::vector<cv::Point2f>> FindChessboard(const cv::Mat& green, cv::Size inner);

// The same corners on the board itself: z = 0, mm, origin at the board's centre, x along a row.
std::vector<cv::Point3f> ChessboardPoints(cv::Size inner, double square_mm);

}  // namespace dorsum
