// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

namespace dorsum {

// A half-line; the direction has unit length.
struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d At(double t) const { return origin + t * direction; }
};

// All points p with normal . p = offset; the normal has unit length.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;

  double SignedDistance(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
};

// Distance along the ray to the plane; none where the ray runs along it or away from it.
inline std::optional<double> Intersect(const Ray& ray, const Plane& plane) {
  const double slope = plane.normal.dot(ray.direction);
  if (std::abs(slope) < 1e-12) return std::nullopt;
  const double t = -plane.SignedDistance(ray.origin) / slope;
  if (t < 0.0) return std::nullopt;
  return t;
}

}  // namespace dorsum
