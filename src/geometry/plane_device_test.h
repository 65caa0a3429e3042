// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "geometry/calibration.h"

namespace dorsum {

// A small device without lens distortion, for tests: the camera looks straight down from 400 mm, and the
// plane sheets of a laser go through its grating, 300 mm up, and through lines every 8 mm on the backplane.
inline constexpr double kTestCameraHeight = 400.0, kTestGratingHeight = 300.0, kTestSpacing = 8.0;

inline Camera TestCamera() {
  Camera camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 800.0;
  camera.cx = 320.0;
  camera.cy = 240.0;
  camera.camera_from_world.rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  camera.camera_from_world.translation = {0.0, 0.0, kTestCameraHeight};
  return camera;
}

// The sheet through the grating and the line x = at + slope * y on the backplane.
inline PlaneSheet TestSheet(const Eigen::Vector3d& grating, int order, double at, double slope = 0.0) {
  const Eigen::Vector3d on_line(at, 0.0, 0.0);
  Eigen::Vector3d normal = Eigen::Vector3d(slope, 1.0, 0.0).cross(grating - on_line).normalized();
  if (normal.x() < 0.0) normal = -normal;
  return {order, {normal, normal.dot(on_line)}};
}

inline LaserGeometry TestLaser(int laser, double grating_x, int min_order = -20, int max_order = 20) {
  LaserGeometry out;
  out.laser = laser;
  out.grating = {grating_x, 0.0, kTestGratingHeight};
  out.min_order = min_order;
  out.max_order = max_order;
  for (int m = min_order; m <= max_order; ++m) {
    out.planes.push_back(TestSheet(out.grating, m, grating_x + kTestSpacing * m, 0.01 * m));
  }
  return out;
}

inline DeviceGeometry TestDevice() {
  DeviceGeometry device;
  device.camera = TestCamera();
  device.lasers = {TestLaser(0, -60.0), TestLaser(1, 60.0)};
  return device;
}

// Where the sheet of an order is at height z, for a given y; a plane sheet that is not level.
inline Eigen::Vector3d OnSheet(const PlaneSheet& sheet, double y, double z) {
  const Eigen::Vector3d& n = sheet.plane.normal;
  return {(sheet.plane.offset - n.y() * y - n.z() * z) / n.x(), y, z};
}

}  // namespace dorsum
