// SPDX-License-Identifier: Apache-2.0
#include "report/design_pictures.h"

#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "report/drawing.h"

namespace dorsum {
namespace {

DesignDrawing SmallDrawing() {
  DesignDrawing d;
  d.camera.width = 640;
  d.camera.height = 480;
  d.camera.fx = d.camera.fy = 800.0;
  d.camera.cx = 319.5;
  d.camera.cy = 239.5;
  d.camera.camera_from_world.rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  d.camera.camera_from_world.translation = {0.0, 0.0, 400.0};
  d.gratings = {{0.0, 0.0, 390.0}};
  d.stripes = {{0, 0, {{0.0, -60.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 60.0, 0.0}}},
               {0, 1, {{40.0, -60.0, 0.0}, {40.0, 0.0, 0.0}, {40.0, 60.0, 0.0}}}};
  d.hand = {Eigen::Vector2d(-80.0, -50.0), Eigen::Vector2d(80.0, 50.0)};
  return d;
}

bool HasColour(const cv::Mat& picture, const cv::Point& at, const Colour& colour, int reach) {
  for (int v = at.y - reach; v <= at.y + reach; ++v) {
    for (int u = at.x - reach; u <= at.x + reach; ++u) {
      if (cv::norm(picture.at<Colour>(v, u), colour, cv::NORM_INF) < 12.0) return true;
    }
  }
  return false;
}

// A stripe 40 mm off is 80 px off at 400 mm and 800 px; the picture has twice the camera's pixels.
TEST(DesignPictures, StripesLieWhereTheCameraSeesThem) {
  const cv::Mat picture = DrawDesignAsSeen(SmallDrawing(), 1280);
  EXPECT_EQ(picture.size(), cv::Size(1280, 960));
  EXPECT_TRUE(HasColour(picture, {640, 420}, OrderColour(0), 2));
  EXPECT_TRUE(HasColour(picture, {800, 420}, OrderColour(1), 2));
  EXPECT_FALSE(HasColour(picture, {720, 420}, OrderColour(1), 20));
}

TEST(DesignPictures, ADeviceFarToOneSideStillFitsThePicture) {
  DesignDrawing d = SmallDrawing();
  d.gratings.emplace_back(500.0, 0.0, 900.0);
  d.stripes.push_back({1, -3, {{1e6, 0.0, 0.0}}});
  d.stripes.push_back({1, 2, {}});
  const cv::Mat picture = DrawDesignFromTheSide(d, {800, 600});
  EXPECT_EQ(picture.size(), cv::Size(800, 600));
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  EXPECT_GT(cv::countNonZero(grey > 200), 1000);
}

TEST(DesignPictures, CurvesBreakWhereThereIsNoValue) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const DesignCurve whole{"a", {{0.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}, {3.0, 1.0}}};
  DesignCurve broken = whole;
  broken.points[1].y() = none;
  const auto ink = [](const cv::Mat& picture) {
    cv::Mat grey;
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    return cv::countNonZero(grey < 150);
  };
  EXPECT_LT(ink(DrawDesignCurves({broken}, "x", "y")), ink(DrawDesignCurves({whole}, "x", "y")) - 200);
  EXPECT_EQ(DrawDesignCurves({}, "x", "y").size(), cv::Size(960, 720));
}

}  // namespace
}  // namespace dorsum
