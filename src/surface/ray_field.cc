// SPDX-License-Identifier: Apache-2.0
#include "surface/ray_field.h"

#include <algorithm>

namespace dorsum {
namespace {

constexpr double kStepPx = 4.0;

}  // namespace

RayField::RayField(const Camera& camera, const cv::Rect& part)
    : center_(camera.Center()),
      u0_(part.x - kStepPx),
      v0_(part.y - kStepPx),
      slope_(static_cast<int>(part.height / kStepPx) + 4, static_cast<int>(part.width / kStepPx) + 4) {
  for (int r = 0; r < slope_.rows; ++r) {
    for (int c = 0; c < slope_.cols; ++c) {
      const Eigen::Vector3d d = CastRay(camera, {u0_ + kStepPx * c, v0_ + kStepPx * r}).direction;
      slope_(r, c) = {d.x() / d.z(), d.y() / d.z()};
    }
  }
}

RayField::Slope RayField::SlopeAt(double u, double v) const {
  const double x = (u - u0_) / kStepPx, y = (v - v0_) / kStepPx;
  const int c = std::clamp(static_cast<int>(x), 0, slope_.cols - 2),
            r = std::clamp(static_cast<int>(y), 0, slope_.rows - 2);
  const double fx = x - c, fy = y - r;
  const cv::Vec2d *north = slope_.ptr<cv::Vec2d>(r) + c, *south = slope_.ptr<cv::Vec2d>(r + 1) + c;
  Slope out;
  for (int i = 0; i < 2; ++i) {
    const double top = north[0][i] + fx * (north[1][i] - north[0][i]);
    const double bottom = south[0][i] + fx * (south[1][i] - south[0][i]);
    out.m[i] = top + fy * (bottom - top);
    out.du[i] = ((1.0 - fy) * (north[1][i] - north[0][i]) + fy * (south[1][i] - south[0][i])) / kStepPx;
    out.dv[i] = (bottom - top) / kStepPx;
  }
  return out;
}

Eigen::Vector3d RayField::At(double u, double v, double z) const {
  const Eigen::Vector2d m = SlopeAt(u, v).m;
  const double rise = z - center_.z();
  return {center_.x() + rise * m.x(), center_.y() + rise * m.y(), z};
}

}  // namespace dorsum
