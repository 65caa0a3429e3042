// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <opencv2/core.hpp>

namespace dorsum {

inline constexpr int kSlopeReach = 3;  // px before a step and after it between which the slope is taken

// Difference of light between a pixel and its neighbour, at p[way], less the slope that it sits on: what a
// sharp outline has and the soft edge of a shadow has not. Never negative.
inline float SharpStep(const float* p, std::ptrdiff_t way) {
  const float step = p[way] - p[0];
  const float slope =
      (p[(kSlopeReach + 1) * way] - p[-kSlopeReach * way]) / static_cast<float>(2 * kSlopeReach + 1);
  const float sharp = std::max(0.0F, std::abs(step) - std::abs(slope));
  return step * slope <= 0.0F ? std::abs(step) : sharp;
}

// Whether that reads nothing outside of a picture, whatever the way.
inline bool HasSlopes(cv::Size size, cv::Point p) {
  constexpr int kEdge = kSlopeReach + 1;
  return p.x >= kEdge && p.y >= kEdge && p.x < size.width - kEdge && p.y < size.height - kEdge;
}

// The same of any pixel of a picture (CV_32FC1); where the slope is not seen, the whole difference.
inline float SharpStep(const cv::Mat& light, cv::Point p, cv::Point way) {
  const auto* there = light.ptr<float>(p.y) + p.x;
  const std::ptrdiff_t to_next = way.y * static_cast<std::ptrdiff_t>(light.step1()) + way.x;
  const cv::Rect image({0, 0}, light.size());
  const bool seen = image.contains(p - kSlopeReach * way) && image.contains(p + (kSlopeReach + 1) * way);
  return seen ? SharpStep(there, to_next) : std::abs(there[to_next] - there[0]);
}

}  // namespace dorsum
