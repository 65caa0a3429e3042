// SPDX-License-Identifier: Apache-2.0
#include "captures/designed_geometry.h"

#include <numbers>

#include <Eigen/Geometry>

namespace dorsum {

Rigid3 LookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  const Eigen::Vector3d z = (target - position).normalized();
  const Eigen::Vector3d x = (Eigen::Vector3d::UnitX() - z.x() * z).normalized();
  Rigid3 camera_from_design;
  camera_from_design.rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
  camera_from_design.translation = -(camera_from_design.rotation * position);
  return camera_from_design;
}

Camera DesignedCamera(const CameraDesign& design) {
  Camera camera;
  camera.width = design.width;
  camera.height = design.height;
  camera.fx = camera.fy = design.focal_length_px;
  camera.cx = 0.5 * (design.width - 1);
  camera.cy = 0.5 * (design.height - 1);
  camera.distortion = design.distortion;
  camera.camera_from_world = LookAt(design.position_mm, design.look_at_mm);
  return camera;
}

DiffractedFan DesignedFan(const LaserDesign& laser, const GratingDesign& grating) {
  DiffractedFan fan;
  fan.origin = laser.position_mm;
  fan.fan_distance_mm = laser.fan_distance_mm;
  fan.tilt = laser.tilt_deg * std::numbers::pi / 180.0;
  fan.step = grating.Step();
  fan.form = laser.form;
  return fan;
}

}  // namespace dorsum
