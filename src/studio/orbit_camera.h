// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "geometry/ray.h"

namespace dorsum {

// Where a surface is looked at from: on a sphere about a target, z upwards, in perspective. World frame, mm,
// degrees. Home looks from the side of smaller y at a slant.
class OrbitCamera {
 public:
  // Sees the whole box; this becomes the home view.
  void Frame(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
  void Home();

  void Turn(double yaw_deg, double pitch_deg);
  void Pan(double right, double up);  // in heights of the view
  void Zoom(double factor);           // above 1: nearer

  // Clip coordinates (OpenGL's) from world. `aspect` is width over height.
  Eigen::Matrix4f ClipFromWorld(double aspect) const;
  Eigen::Matrix3f ViewFromWorld() const;  // rotation alone: x right, y up, z towards the eye
  // The ray of a place of the view: x, y in [-1, 1], y up.
  Ray Through(double x, double y, double aspect) const;
  // mm at the target that a whole height of the view spans.
  double HeightAtTarget() const;

  const Eigen::Vector3d& target() const { return target_; }
  double distance() const { return distance_; }
  double yaw_deg() const { return yaw_deg_; }
  double pitch_deg() const { return pitch_deg_; }

 private:
  Eigen::Matrix3d Axes() const;  // rows: right, up, towards the eye

  Eigen::Vector3d target_ = Eigen::Vector3d::Zero(), home_ = Eigen::Vector3d::Zero();
  double radius_ = 100.0, distance_ = 300.0, yaw_deg_ = 0.0, pitch_deg_ = 50.0;
};

}  // namespace dorsum
