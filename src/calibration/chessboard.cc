// SPDX-License-Identifier: Apache-2.0
#include "calibration/chessboard.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// Smallest distance between neighbouring corners, which bounds the window of the refinement.
double SmallestSpacing(const std::vector<cv::Point2f>& corners, cv::Size inner) {
  double least = 1e9;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (static_cast<int>(i) % inner.width != 0)
      least = std::min(least, cv::norm(corners[i] - corners[i - 1]));
  }
  return least;
}

// OpenCV may begin at either end of the board; begin where rows run along growing u (or v, for an upright
// board).
void OrderFromTopLeft(std::vector<cv::Point2f>* corners, cv::Size inner) {
  const cv::Point2f along = (*corners)[static_cast<std::size_t>(inner.width) - 1] - corners->front();
  const float main = std::abs(along.x) > std::abs(along.y) ? along.x : along.y;
  if (main < 0.0F) std::reverse(corners->begin(), corners->end());
}

}  // namespace

std::optional<std::vector<cv::Point2f>> FindChessboard(const cv::Mat& green, cv::Size inner) {
  std::vector<cv::Point2f> corners;
  const int flags = cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK;
  if (!cv::findChessboardCorners(green, inner, corners, flags)) return std::nullopt;
  const int half = std::clamp(static_cast<int>(0.35 * SmallestSpacing(corners, inner)), 2, 15);
  cv::cornerSubPix(green, corners, {half, half}, {-1, -1},
                   {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 60, 1e-4});
  OrderFromTopLeft(&corners, inner);
  return corners;
}

std::vector<cv::Point3f> ChessboardPoints(cv::Size inner, double square_mm) {
  std::vector<cv::Point3f> points;
  for (int r = 0; r < inner.height; ++r) {
    for (int c = 0; c < inner.width; ++c) {
      points.emplace_back(static_cast<float>((c - 0.5 * (inner.width - 1)) * square_mm),
                          static_cast<float>((r - 0.5 * (inner.height - 1)) * square_mm), 0.0F);
    }
  }
  return points;
}

}  // namespace dorsum
