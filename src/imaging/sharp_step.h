// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

// Difference of light (CV_32FC1) between a pixel and its neighbour q = p + way, less the slope that it sits
// on: what a sharp outline has and the soft edge of a shadow has not. Never negative.
inline float SharpStep(const cv::Mat& light, cv::Point p, cv::Point way) {
  constexpr int kReach = 3;  // px before p and after q between which the slope is taken
  const float step = light.at<float>(p + way) - light.at<float>(p);
  const cv::Point before = p - kReach * way, after = p + (kReach + 1) * way;
  const cv::Rect image({0, 0}, light.size());
  if (!image.contains(before) || !image.contains(after)) return std::abs(step);
  const float slope = (light.at<float>(after) - light.at<float>(before)) / static_cast<float>(2 * kReach + 1);
  if (step * slope <= 0.0F) return std::abs(step);
  return std::max(0.0F, std::abs(step) - std::abs(slope));
}

}  // namespace dorsum
