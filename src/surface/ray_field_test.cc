// SPDX-License-Identifier: Apache-2.0
#include "surface/ray_field.h"

#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

TEST(RayFieldTest, PointsLieOnTheirRays) {
  Camera camera = TestCamera();
  camera.distortion = {-0.2, 0.08, 0.001, -0.0005, 0.0};
  const RayField rays(camera, cv::Rect(0, 0, camera.width, camera.height));
  for (const double u : {0.0, 3.7, 211.2, 639.0}) {
    for (const double v : {0.0, 100.9, 479.0}) {
      const Eigen::Vector3d p = rays.At(u, v, 25.0);
      EXPECT_EQ(p.z(), 25.0);
      EXPECT_LT((Project(camera, p) - Eigen::Vector2d(u, v)).norm() * 0.5, 1e-3);  // mm
    }
  }
}

}  // namespace
}  // namespace dorsum
