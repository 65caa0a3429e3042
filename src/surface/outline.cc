// SPDX-License-Identifier: Apache-2.0
#include "surface/outline.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// Distance from the centre of each pixel that is set to the nearest one that is not; none across the border.
cv::Mat1f DistanceInside(const cv::Mat& region) {
  cv::Mat padded;
  cv::copyMakeBorder(region, padded, 1, 1, 1, 1, cv::BORDER_REPLICATE);
  cv::Mat1f out;
  cv::distanceTransform(padded, out, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return out(cv::Rect(1, 1, region.cols, region.rows)).clone();
}

}  // namespace

Outline::Outline(const cv::Mat& mask, int margin_px) : outside_(-static_cast<float>(margin_px)) {
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
  const cv::Mat1f in = DistanceInside(inside), out = DistanceInside(~inside);
  distance_ = cv::Mat1f(bounds_.size());
  for (int r = 0; r < bounds_.height; ++r) {
    for (int c = 0; c < bounds_.width; ++c) {
      distance_(r, c) = in(r, c) > 0.0F ? in(r, c) - 0.5F : std::max(0.5F - out(r, c), outside_);
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
  const float a = distance_(r, c) + fx * (distance_(r, c1) - distance_(r, c));
  const float b = distance_(r1, c) + fx * (distance_(r1, c1) - distance_(r1, c));
  return a + fy * (b - a);
}

}  // namespace dorsum
