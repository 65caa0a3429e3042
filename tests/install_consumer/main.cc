// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "geometry/camera.h"

// Projects a point on the optical axis, 400 mm away, through the installed library.
int main() {
  dorsum::Camera camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 800.0;
  camera.cx = 319.5;
  camera.cy = 239.5;
  const Eigen::Vector2d pixel = dorsum::Project(camera, Eigen::Vector3d(0.0, 0.0, 400.0));
  std::printf("%.1f %.1f\n", pixel.x(), pixel.y());
  return std::hypot(pixel.x() - camera.cx, pixel.y() - camera.cy) < 1e-9 ? 0 : 1;
}
