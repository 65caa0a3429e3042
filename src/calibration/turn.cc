// SPDX-License-Identifier: Apache-2.0
#include "calibration/turn.h"

#include <cmath>

#include <Eigen/Geometry>

namespace dorsum {

Eigen::Matrix3d Cross(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

Eigen::Matrix3d TurnMatrix(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

Eigen::Matrix3d TurnGrowth(const Eigen::Vector3d& turn) {
  const double angle2 = turn.squaredNorm(), angle = std::sqrt(angle2);
  // (1 - cos a) / a^2 and (a - sin a) / a^3, by their series where the differences lose digits.
  const bool small = angle < 1e-2;
  const double half = std::sin(0.5 * angle);
  const double first = small ? 0.5 - angle2 / 24.0 + angle2 * angle2 / 720.0 : 2.0 * half * half / angle2;
  const double second = small ? 1.0 / 6.0 - angle2 / 120.0 + angle2 * angle2 / 5040.0
                              : (angle - std::sin(angle)) / (angle2 * angle);
  const Eigen::Matrix3d cross = Cross(turn);
  return Eigen::Matrix3d::Identity() - first * cross + second * cross * cross;
}

}  // namespace dorsum
