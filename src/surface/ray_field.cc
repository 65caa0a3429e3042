// SPDX-License-Identifier: Apache-2.0
#include "surface/ray_field.h"

#include <algorithm>
#include <array>
#include <vector>

namespace dorsum {
namespace {

constexpr double kStepPx = 4.0;

}  // namespace

// The lens is asked at every fourth node; cubics through four of those give the others to 1e-6 of a slope.
RayField::RayField(const Camera& camera, const cv::Rect& part)
    : center_(camera.Center()),
      u0_(part.x - kStepPx),
      v0_(part.y - kStepPx),
      slope_(static_cast<int>(part.height / kStepPx) + 4, static_cast<int>(part.width / kStepPx) + 4) {
  constexpr int kEach = 4;
  cv::Mat_<cv::Vec2d> known((slope_.rows - 1) / kEach + 4, (slope_.cols - 1) / kEach + 4);
  for (int r = 0; r < known.rows; ++r) {
    for (int c = 0; c < known.cols; ++c) {
      const Eigen::Vector2d at(u0_ + kStepPx * kEach * (c - 1), v0_ + kStepPx * kEach * (r - 1));
      const Eigen::Vector3d d = CastRay(camera, at).direction;
      known(r, c) = {d.x() / d.z(), d.y() / d.z()};
    }
  }
  // Lagrange's weights of the four around a place.
  std::array<std::array<double, 4>, kEach> weights{};
  for (int k = 0; k < kEach; ++k) {
    const double t = static_cast<double>(k) / kEach;
    weights[static_cast<std::size_t>(k)] = {
        -t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
        -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
  }
  std::vector<cv::Vec2d> row(static_cast<std::size_t>(known.cols));
  for (int r = 0; r < slope_.rows; ++r) {
    const auto& down = weights[static_cast<std::size_t>(r % kEach)];
    for (int c = 0; c < known.cols; ++c) {
      cv::Vec2d sum(0.0, 0.0);
      for (int k = 0; k < 4; ++k) sum += known(r / kEach + k, c) * down[static_cast<std::size_t>(k)];
      row[static_cast<std::size_t>(c)] = sum;
    }
    for (int c = 0; c < slope_.cols; ++c) {
      const auto& across = weights[static_cast<std::size_t>(c % kEach)];
      const auto* around = &row[static_cast<std::size_t>(c / kEach)];
      slope_(r, c) =
          around[0] * across[0] + around[1] * across[1] + around[2] * across[2] + around[3] * across[3];
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
