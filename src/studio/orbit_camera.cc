// SPDX-License-Identifier: Apache-2.0
#include "studio/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dorsum {
namespace {

constexpr double kHomePitch_deg = 50.0;
constexpr double kFieldOfView_deg = 35.0;  // vertical
const double kTanHalf = std::tan(0.5 * kFieldOfView_deg * std::numbers::pi / 180.0);

}  // namespace

void OrbitCamera::Frame(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  home_ = 0.5 * (low + high);
  radius_ = std::max(0.5 * (high - low).norm(), 1.0);
  Home();
}

void OrbitCamera::Home() {
  target_ = home_;
  yaw_deg_ = 0.0;
  pitch_deg_ = kHomePitch_deg;
  distance_ = 1.05 * radius_ / kTanHalf;  // a view as high as wide holds it too
}

void OrbitCamera::Turn(double yaw_deg, double pitch_deg) {
  yaw_deg_ = std::remainder(yaw_deg_ + yaw_deg, 360.0);
  pitch_deg_ = std::clamp(pitch_deg_ + pitch_deg, -89.9, 89.9);
}

void OrbitCamera::Pan(double right, double up) {
  const Eigen::Matrix3d axes = Axes();
  target_ += HeightAtTarget() * (right * axes.row(0) + up * axes.row(1)).transpose();
}

void OrbitCamera::Zoom(double factor) {
  distance_ = std::clamp(distance_ / factor, 0.02 * radius_, 20.0 * radius_);
}

double OrbitCamera::HeightAtTarget() const { return 2.0 * distance_ * kTanHalf; }

Eigen::Matrix3d OrbitCamera::Axes() const {
  const double yaw = yaw_deg_ * std::numbers::pi / 180.0, pitch = pitch_deg_ * std::numbers::pi / 180.0;
  const Eigen::Vector3d to_eye(std::sin(yaw) * std::cos(pitch), -std::cos(yaw) * std::cos(pitch),
                               std::sin(pitch));
  const Eigen::Vector3d right(std::cos(yaw), std::sin(yaw), 0.0);
  const Eigen::Vector3d up(to_eye.y() * right.z() - to_eye.z() * right.y(),
                           to_eye.z() * right.x() - to_eye.x() * right.z(),
                           to_eye.x() * right.y() - to_eye.y() * right.x());
  Eigen::Matrix3d axes;
  axes << right.transpose(), up.transpose(), to_eye.transpose();
  return axes;
}

Eigen::Matrix3f OrbitCamera::ViewFromWorld() const { return Axes().cast<float>(); }

Eigen::Matrix4f OrbitCamera::ClipFromWorld(double aspect) const {
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = Axes();
  view.topRightCorner<3, 1>() = -(Axes() * target_) - Eigen::Vector3d(0.0, 0.0, distance_);
  const double far = distance_ + 30.0 * radius_, near = std::max(distance_ - 3.0 * radius_, 1e-3 * distance_);
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 1.0 / (kTanHalf * aspect);
  clip(1, 1) = 1.0 / kTanHalf;
  clip(2, 2) = -(far + near) / (far - near);
  clip(2, 3) = -2.0 * far * near / (far - near);
  clip(3, 2) = -1.0;
  return (clip * view).cast<float>();
}

Ray OrbitCamera::Through(double x, double y, double aspect) const {
  const Eigen::Matrix3d axes = Axes();
  Ray ray;
  ray.origin = target_ + distance_ * axes.row(2).transpose();
  ray.direction =
      (axes.transpose() * Eigen::Vector3d(x * kTanHalf * aspect, y * kTanHalf, -1.0)).normalized();
  return ray;
}

}  // namespace dorsum
