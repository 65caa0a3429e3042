// SPDX-License-Identifier: Apache-2.0
#include "geometry/camera.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace dorsum {
namespace {

// Of Distort(), by the normalised point.
Eigen::Matrix2d DistortionJacobian(const Camera& camera, const Eigen::Vector2d& p) {
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  const double x = p.x(), y = p.y();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3);  // d radial / d r2
  const double cross = 2.0 * x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y;
  Eigen::Matrix2d jacobian;
  jacobian << radial + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x, cross, cross,
      radial + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
  return jacobian;
}

}  // namespace

Eigen::Vector2d Undistort(const Camera& camera, const Eigen::Vector2d& distorted) {
  Eigen::Vector2d p = distorted;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector2d step = DistortionJacobian(camera, p).inverse() * (distorted - Distort(camera, p));
    p += step;
    if (step.squaredNorm() < 1e-26) break;
  }
  return p;
}

Eigen::Vector2d Project(const Camera& camera, const Eigen::Vector3d& world) {
  const Eigen::Vector3d p = camera.camera_from_world * world;
  const Eigen::Vector2d d = Distort(camera, p.head<2>() / p.z());
  return {camera.fx * d.x() + camera.cx, camera.fy * d.y() + camera.cy};
}

Ray CastRay(const Camera& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d d((pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy);
  const Eigen::Vector3d in_camera = Undistort(camera, d).homogeneous();
  const Rigid3& cw = camera.camera_from_world;
  return {camera.Center(), (cw.rotation.transpose() * in_camera).normalized()};
}

}  // namespace dorsum
