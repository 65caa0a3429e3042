// SPDX-License-Identifier: Apache-2.0
#include "stripes/backplane_check.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stripes/append_segment.h"

namespace dorsum {
namespace {

// A camera that looks straight down from 400 mm, and vertical plane sheets 15 mm apart.
DeviceGeometry Device() {
  DeviceGeometry device;
  device.camera.width = 800;
  device.camera.height = 600;
  device.camera.fx = device.camera.fy = 1000.0;
  device.camera.cx = 400.0;
  device.camera.cy = 300.0;
  device.camera.camera_from_world.rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  device.camera.camera_from_world.translation = {0.0, 0.0, 400.0};
  LaserGeometry& laser = device.lasers.emplace_back();
  laser.grating = {0.0, 0.0, 400.0};
  laser.min_order = -8;
  laser.max_order = 8;
  for (int order = laser.min_order; order <= laser.max_order; ++order) {
    PlaneSheet& sheet = laser.planes.emplace_back();
    sheet.order = order;
    sheet.plane = {Eigen::Vector3d::UnitX(), 15.0 * order};
  }
  return device;
}

// Stripes of the backplane, 37.5 px apart, moved by `shift_px`; the rows of [from, to) are moved by 15 px
// more, as an object does.
std::vector<LaserStripes> Stripes(double shift_px, int from, int to) {
  LaserStripes one;
  for (int order = -8; order <= 8; ++order) {
    std::vector<StripePoint> points;
    for (int v = 0; v < 600; ++v) {
      StripePoint p;
      p.u = static_cast<float>(400.0 + 37.5 * order + shift_px + (v >= from && v < to ? 15.0 : 0.0));
      p.v = static_cast<float>(v);
      points.push_back(p);
    }
    AppendSegment(points, std::nullopt, &one);
  }
  return {one};
}

BackplaneCheck Check(double shift_px, int from = 0, int to = 0) {
  const cv::Mat everywhere(600, 800, CV_8UC1, cv::Scalar(255));
  const auto checks = CheckBackplane(Stripes(shift_px, from, to), DeviceOrders(Device()), everywhere, {});
  EXPECT_EQ(checks.size(), 1U);
  return checks.empty() ? BackplaneCheck{} : checks[0];
}

TEST(BackplaneCheckTest, StripesInTheirPlacesAreFine) {
  const BackplaneCheck check = Check(0.1);
  EXPECT_FALSE(check.moved);
  EXPECT_NEAR(check.shift_px, 0.1, 1e-3);
  EXPECT_GT(check.points, 1000);
}

TEST(BackplaneCheckTest, AnObjectIsNoKnock) { EXPECT_FALSE(Check(0.1, 100, 300).moved); }

TEST(BackplaneCheckTest, AKnockIsNoticedBesideAnObject) {
  const BackplaneCheck check = Check(5.0, 100, 300);
  EXPECT_TRUE(check.moved);
  EXPECT_NEAR(check.shift_px, 5.0, 1e-3);
}

TEST(BackplaneCheckTest, NothingIsSaidOfAPictureWithoutBackplane) {
  const cv::Mat nowhere(600, 800, CV_8UC1, cv::Scalar(0));
  const auto checks = CheckBackplane(Stripes(5.0, 0, 0), DeviceOrders(Device()), nowhere, {});
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_FALSE(checks[0].moved);
  EXPECT_EQ(checks[0].points, 0);
}

}  // namespace
}  // namespace dorsum
