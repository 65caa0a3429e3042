// SPDX-License-Identifier: Apache-2.0
#include "calibration/rectification.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "calibration/chessboard.h"
#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

const cv::Size kInner(9, 6);
constexpr double kSquare = 15.0;

// A distorted camera that looks at a board from a little aside.
Camera SlantedCamera() {
  Camera camera = TestCamera();
  camera.distortion = {-0.12, 0.06, 0.001, -0.0015, 0.0};
  camera.camera_from_world.rotation = (Eigen::AngleAxisd(0.12, Eigen::Vector3d(1.0, 0.5, 0.2).normalized()) *
                                       camera.camera_from_world.rotation)
                                          .eval();
  return camera;
}

// Board coordinates have y downwards in the image; the board lies in the world's plane z = 0.
Eigen::Vector3d WorldFromBoard(double x, double y) { return {x + 7.0, -y - 3.0, 0.0}; }

std::vector<cv::Point2f> Corners(const Camera& camera) {
  std::vector<cv::Point2f> corners;
  for (const cv::Point3f& p : ChessboardPoints(kInner, kSquare)) {
    const Eigen::Vector2d pixel = Project(camera, WorldFromBoard(p.x, p.y));
    corners.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  }
  return corners;
}

TEST(Rectification, PlacesOfThePlaneAreWhereTheCameraSeesThem) {
  const Camera camera = SlantedCamera();
  const Rectification r = RectifyFromBoard(camera, Corners(camera), kInner, kSquare);
  EXPECT_LT(r.rms_mm, 1e-4);
  for (const double x : {-80.0, 0.0, 95.0}) {
    for (const double y : {-60.0, 0.0, 70.0}) {
      const Eigen::Vector2d pixel = Project(camera, WorldFromBoard(x, y));
      EXPECT_LT((PlaneFromPixel(camera, r, pixel) - Eigen::Vector2d(x, y)).norm(), 2e-3);
      EXPECT_LT((PixelFromPlane(camera, r, {x, y}) - pixel).norm(), 5e-3);
      EXPECT_LT((PixelFromPlane(camera, r, PlaneFromPixel(camera, r, pixel)) - pixel).norm(), 1e-6);
    }
  }
}

TEST(Rectification, TheRatioIsPixelsPerMillimetreOnTheBoard) {
  const Camera camera = TestCamera();
  const Rectification r = RectifyFromBoard(camera, Corners(camera), kInner, kSquare);
  EXPECT_NEAR(r.px_per_mm, camera.fx / kTestCameraHeight, 1e-5);
  EXPECT_NEAR(r.area_mm.width, 639.0 / r.px_per_mm, 0.01);
  EXPECT_NEAR(r.area_mm.height, 479.0 / r.px_per_mm, 0.01);
}

TEST(Rectification, ANoisyCornerShowsInTheResidual) {
  const Camera camera = TestCamera();
  std::vector<cv::Point2f> corners = Corners(camera);
  corners[10].x += 4.0F;
  EXPECT_GT(RectifyFromBoard(camera, corners, kInner, kSquare).rms_mm, 0.1);
}

TEST(Rectification, TheWarpedPictureShowsThePlaneAtItsScale) {
  const Camera camera = SlantedCamera();
  const Rectification r = RectifyFromBoard(camera, Corners(camera), kInner, kSquare);
  cv::Mat image(camera.height, camera.width, CV_8UC1, cv::Scalar(10));
  const Eigen::Vector2d spot = PixelFromPlane(camera, r, {30.0, -20.0});
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double d2 = (Eigen::Vector2d(u, v) - spot).squaredNorm();
      image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(10.0 + 200.0 * std::exp(-d2 / 18.0));
    }
  }
  const cv::Mat flat = WarpToPlane(image, camera, r);
  cv::Point brightest;
  cv::minMaxLoc(flat, nullptr, nullptr, nullptr, &brightest);
  EXPECT_NEAR(r.area_mm.x + brightest.x / r.px_per_mm, 30.0, 0.6);
  EXPECT_NEAR(r.area_mm.y + brightest.y / r.px_per_mm, -20.0, 0.6);
}

TEST(Rectification, AnEndlessAreaIsCutToAPictureThatFitsMemory) {
  const Camera camera = TestCamera();
  Rectification r = RectifyFromBoard(camera, Corners(camera), kInner, kSquare);
  r.area_mm = {-1e7, -1.0, 2e7, 2.0};
  EXPECT_LE(WarpToPlane(cv::Mat(480, 640, CV_8UC1, cv::Scalar(9)), camera, r).cols, 8000);
}

}  // namespace
}  // namespace dorsum
