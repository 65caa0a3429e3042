// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

#include "geometry/ray.h"
#include "geometry/rigid3.h"

namespace dorsum {

// Pin-hole camera with Brown-Conrady distortion (document §2.3; OpenCV's model and order k1 k2 p1 p2 k3).
// Pixel centres are at integer coordinates; the camera looks along +z, x right, y down.
struct Camera {
  int width = 0, height = 0;  // px
  double fx = 0.0, fy = 0.0;  // focal lengths, px
  double cx = 0.0, cy = 0.0;  // principal point, px
  std::array<double, 5> distortion{};
  Rigid3 camera_from_world;

  Eigen::Vector3d Center() const { return camera_from_world.Inverse().translation; }
};

// Adds lens distortion to a point of the normalised image plane (x/z, y/z).
inline Eigen::Vector2d Distort(const Camera& camera, const Eigen::Vector2d& normalized) {
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  const double x = normalized.x(), y = normalized.y(), r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

// Takes lens distortion away again, by Newton's method to below 1e-12. Inverse of Distort where the
// distortion is one-to-one, which holds inside the image of any real lens.
Eigen::Vector2d Undistort(const Camera& camera, const Eigen::Vector2d& distorted);

// Image point (px, distorted) of a world point (mm) in front of the camera.
Eigen::Vector2d Project(const Camera& camera, const Eigen::Vector3d& world);

// The world ray that an image point (px, distorted) sees.
Ray CastRay(const Camera& camera, const Eigen::Vector2d& pixel);

}  // namespace dorsum
