// SPDX-License-Identifier: Apache-2.0
#include "surface/outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "surface/border_distance.h"

namespace dorsum {
namespace {

// Distance from the centre of each pixel that is set to the nearest one that is not; none across the border.
cv::Mat1f DistanceInside(const cv::Mat& region) {
  cv::Mat padded;
  cv::copyMakeBorder(region, padded, 1, 1, 1, 1, cv::BORDER_REPLICATE);
  cv::Mat1f out;
  cv::distanceTransform(padded, out, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return out(cv::Rect(1, 1, region.cols, region.rows));
}

}  // namespace

Outline::Outline(const cv::Mat& mask, int margin_px, int reach_px, const Context& context)
    : outside_(-static_cast<float>(margin_px)) {
  const cv::Rect object = cv::boundingRect(mask);
  bounds_ = cv::Rect(object.x - margin_px, object.y - margin_px, object.width + 2 * margin_px,
                     object.height + 2 * margin_px) &
            cv::Rect(0, 0, mask.cols, mask.rows);
  if (object.empty()) return;
  const cv::Mat inside = mask(bounds_) != 0;
  if (cv::countNonZero(inside) == bounds_.area()) {
    distance_ = cv::Mat1f(bounds_.size(), static_cast<float>(mask.cols + mask.rows));
    return;
  }
  distance_ = cv::Mat1f(bounds_.size());
  if (reach_px <= kMaxBorderReach && margin_px < kMaxBorderReach) {
    cv::Mat1w in, out;
    ParallelFor(context, 0, 2, [&](std::int64_t part) {
      (part == 0 ? in : out) =
          part == 0 ? SquaredBorderDistance(inside, reach_px) : SquaredBorderDistance(~inside, margin_px + 1);
    });
    std::vector<float> roots;
    const int longest = std::max(reach_px, margin_px + 1);
    for (int i = 0; i <= longest * longest; ++i) roots.push_back(std::sqrt(static_cast<float>(i)));
    ParallelFor(context, 0, bounds_.height, [&](std::int64_t row) {
      const int r = static_cast<int>(row);
      const auto *inwards = in.ptr<std::uint16_t>(r), *outwards = out.ptr<std::uint16_t>(r);
      auto* to = distance_.ptr<float>(r);
      for (int c = 0; c < bounds_.width; ++c) {
        to[c] = inwards[c] > 0 ? roots[inwards[c]] - 0.5F : std::max(0.5F - roots[outwards[c]], outside_);
      }
    });
    return;
  }
  const cv::Mat1f in = DistanceInside(inside), out = DistanceInside(~inside);
  for (int r = 0; r < bounds_.height; ++r) {
    const auto *inwards = in.ptr<float>(r), *outwards = out.ptr<float>(r);
    auto* to = distance_.ptr<float>(r);
    for (int c = 0; c < bounds_.width; ++c) {
      to[c] = inwards[c] > 0.0F ? inwards[c] - 0.5F : std::max(0.5F - outwards[c], outside_);
    }
  }
}

float Outline::Distance(double u, double v) const {
  if (distance_.empty()) return outside_;
  // Beyond the image the nearest pixel's distance goes on.
  const double x = std::clamp(u - bounds_.x, 0.0, bounds_.width - 1.0),
               y = std::clamp(v - bounds_.y, 0.0, bounds_.height - 1.0);
  const int c = std::min(static_cast<int>(x), std::max(0, bounds_.width - 2)),
            r = std::min(static_cast<int>(y), std::max(0, bounds_.height - 2));
  const int c1 = std::min(c + 1, bounds_.width - 1), r1 = std::min(r + 1, bounds_.height - 1);
  const auto fx = static_cast<float>(x - c), fy = static_cast<float>(y - r);
  const auto *north = distance_.ptr<float>(r), *south = distance_.ptr<float>(r1);
  const float a = north[c] + fx * (north[c1] - north[c]), b = south[c] + fx * (south[c1] - south[c]);
  return a + fy * (b - a);
}

cv::Mat1f Outline::AtNodes(double u0, double v0, double step_px, cv::Size size,
                           const Context& context) const {
  cv::Mat1f out(size);
  ParallelFor(context, 0, size.height, [&](std::int64_t r) {
    auto* to = out.ptr<float>(static_cast<int>(r));
    for (int c = 0; c < size.width; ++c)
      to[c] = Distance(u0 + step_px * c, v0 + step_px * static_cast<double>(r));
  });
  return out;
}

}  // namespace dorsum
