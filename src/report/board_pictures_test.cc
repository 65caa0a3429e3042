// SPDX-License-Identifier: Apache-2.0
#include "report/board_pictures.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

Camera CameraAbove() {
  Camera camera;
  camera.width = 800, camera.height = 600;
  camera.fx = camera.fy = 900.0;
  camera.cx = 400.0, camera.cy = 300.0;
  camera.distortion = {-0.08, 0.02, 0.0, 0.0, 0.0};
  camera.camera_from_world.rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  camera.camera_from_world.translation = {0.0, 0.0, 400.0};
  return camera;
}

std::vector<cv::Point2f> Corners(const Camera& camera, double angle, double y_sign) {
  std::vector<cv::Point2f> corners;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      const double x = 15.0 * (column - 2), y = y_sign * 15.0 * (row - 1);
      const Eigen::Vector2d p = Project(camera, {std::cos(angle) * x - std::sin(angle) * y,
                                                 std::sin(angle) * x + std::cos(angle) * y, 0.0});
      corners.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    }
  }
  return corners;
}

TEST(BoardPictures, APerfectBoardReprojectsOntoItselfHoweverItLies) {
  const Camera camera = CameraAbove();
  for (const double angle : {0.0, 0.4, 3.1}) {
    for (const double y_sign : {1.0, -1.0}) {
      const std::vector<cv::Point2f> corners = Corners(camera, angle, y_sign);
      const std::vector<cv::Point2f> expected = ReprojectBoard(camera, corners, {7, 5}, 15.0);
      ASSERT_EQ(expected.size(), corners.size());
      for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_LT(cv::norm(corners[i] - expected[i]), 1e-3);
    }
  }
}

TEST(BoardPictures, AWrongSquareShowsAsError) {
  const Camera camera = CameraAbove();
  const std::vector<cv::Point2f> corners = Corners(camera, 0.1, 1.0);
  const std::vector<cv::Point2f> expected = ReprojectBoard(camera, corners, {7, 5}, 15.3);
  EXPECT_GT(cv::norm(corners.front() - expected.front()), 1.0);
  const cv::Mat photo(600, 800, CV_8UC3, cv::Scalar(10, 90, 10));
  EXPECT_GT(
      cv::norm(DrawReprojection(photo, corners, expected), DrawReprojection(photo, corners, {}), cv::NORM_L1),
      0);
}

TEST(BoardPictures, WrongCountsGiveNoReprojection) {
  EXPECT_TRUE(ReprojectBoard(CameraAbove(), Corners(CameraAbove(), 0.0, 1.0), {7, 6}, 15.0).empty());
  EXPECT_TRUE(ReprojectBoard(CameraAbove(), {}, {0, 0}, 15.0).empty());
  EXPECT_TRUE(DrawReprojection({}, {}, {}).empty());
  EXPECT_TRUE(DrawCornerCoverage({}, {}).empty());
  EXPECT_EQ(DrawCornerCoverage({800, 600}, {{}}, 400).size(), cv::Size(400, 300));
}

}  // namespace
}  // namespace dorsum
