// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace dorsum {

// A rigid motion b_from_a: p_b = rotation * p_a + translation. Variables are named after both frames
// (camera_from_world), so that a_from_b * b_from_c checks itself by eye.
struct Rigid3 {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& p) const { return rotation * p + translation; }
  Rigid3 operator*(const Rigid3& other) const {
    return {rotation * other.rotation, rotation * other.translation + translation};
  }
  Rigid3 Inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
};

}  // namespace dorsum
