// SPDX-License-Identifier: Apache-2.0
#include "geometry/camera.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

Camera TestCamera() {
  Camera camera;
  camera.width = 1600;
  camera.height = 1200;
  camera.fx = 2080.0;
  camera.fy = 2083.0;
  camera.cx = 795.0;
  camera.cy = 606.0;
  camera.distortion = {-0.12, 0.07, 0.0006, -0.0004, 0.02};
  camera.camera_from_world.rotation =
      (Eigen::AngleAxisd(3.1, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  camera.camera_from_world.translation = {-3.0, 2.0, 405.0};
  return camera;
}

TEST(Camera, RayOfAPixelProjectsBackOntoIt) {
  const Camera camera = TestCamera();
  for (double u = -20.0; u < 1625.0; u += 119.7) {
    for (double v = -20.0; v < 1225.0; v += 97.3) {
      const Ray ray = CastRay(camera, {u, v});
      EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-14);
      EXPECT_LT((ray.origin - camera.Center()).norm(), 1e-12);
      for (const double t : {1.0, 380.0, 1000.0}) {
        EXPECT_LT((Project(camera, ray.At(t)) - Eigen::Vector2d(u, v)).norm(), 1e-8);
      }
    }
  }
}

TEST(Camera, UndistortInvertsDistort) {
  const Camera camera = TestCamera();
  for (double x = -0.4; x <= 0.4; x += 0.08) {
    for (double y = -0.3; y <= 0.3; y += 0.06) {
      const Eigen::Vector2d p(x, y);
      EXPECT_LT((Undistort(camera, Distort(camera, p)) - p).norm(), 1e-13);
    }
  }
}

// Numbers worked out by hand from Brown's formula (document §2.3) in OpenCV's order k1 k2 p1 p2 k3.
TEST(Camera, DistortionHasOpenCvsOrderAndSigns) {
  Camera camera;
  const Eigen::Vector2d p(0.3, -0.2);  // r^2 = 0.13
  camera.distortion = {0.1, 0.0, 0.0, 0.0, 0.0};
  EXPECT_LT((Distort(camera, p) - Eigen::Vector2d(0.3039, -0.2026)).norm(), 1e-15);
  camera.distortion = {0.0, 1.0, 0.0, 0.0, 0.0};
  EXPECT_LT((Distort(camera, p) - Eigen::Vector2d(0.30507, -0.20338)).norm(), 1e-15);
  camera.distortion = {0.0, 0.0, 0.01, 0.0, 0.0};  // x += 2 p1 x y, y += p1 (r^2 + 2 y^2)
  EXPECT_LT((Distort(camera, p) - Eigen::Vector2d(0.2988, -0.1979)).norm(), 1e-15);
  camera.distortion = {0.0, 0.0, 0.0, 0.01, 0.0};  // x += p2 (r^2 + 2 x^2), y += 2 p2 x y
  EXPECT_LT((Distort(camera, p) - Eigen::Vector2d(0.3031, -0.2012)).norm(), 1e-15);
  camera.distortion = {0.0, 0.0, 0.0, 0.0, 1.0};
  EXPECT_LT((Distort(camera, p) - Eigen::Vector2d(0.3 * 1.002197, -0.2 * 1.002197)).norm(), 1e-15);
}

TEST(Camera, PrincipalPointSeesTheOpticalAxis) {
  Camera camera = TestCamera();
  const Ray ray = CastRay(camera, {camera.cx, camera.cy});
  const Eigen::Vector3d axis = camera.camera_from_world.rotation.row(2).transpose();
  EXPECT_LT((ray.direction - axis).norm(), 1e-14);
}

}  // namespace
}  // namespace dorsum
