// SPDX-License-Identifier: Apache-2.0
#include "stripes/busy_part.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stripes/joint_scene_test.h"
#include "stripes/ridge_survey.h"

namespace dorsum {
namespace {

// The stripes that a laser shows in the surveyed rows, where the surface has a height; NaN: it shows none.
template <class Height>
LaserStripes Surveyed(const DeviceOrders& orders, int laser, const Height& height) {
  const DeviceGeometry& device = orders.device();
  LaserStripes out;
  out.laser = laser;
  for (int v = 0; v < device.camera.height; ++v) {
    if (!kSurveyedRows.Has(v)) continue;
    double last = NAN;
    for (int u = 0; u < device.camera.width; ++u) {
      const double order = orders.At(laser, u, v)->OrderAt(height(u, v));
      if (std::floor(order) != std::floor(last) && std::isfinite(last) && std::isfinite(order)) {
        const double whole = std::max(std::floor(order), std::floor(last));
        StripePoint p;
        p.u = static_cast<float>(u - (order - whole) / (order - last));
        p.v = static_cast<float>(v);
        out.points.push_back(p);
      }
      last = order;
    }
  }
  return out;
}

class BusyPartTest : public ::testing::Test {
 protected:
  template <class Height>
  cv::Mat Busy(const Height& height, int lasers = 2) const {
    std::vector<LaserStripes> all;
    all.reserve(static_cast<std::size_t>(lasers));
    for (int k = 0; k < lasers; ++k) all.push_back(Surveyed(orders_, k, height));
    return FindBusyPart(all, orders_, unchanged_, {});
  }
  static int Count(const cv::Mat& busy) { return cv::countNonZero(busy); }

  DeviceOrders orders_{FanDevice(2)};
  cv::Mat unchanged_ = cv::Mat(600, 800, CV_8UC1, cv::Scalar(255));
};

bool InBox(double u, double v) { return u > 300 && u < 500 && v > 200 && v < 400; }

TEST_F(BusyPartTest, AnEmptyBackplaneIsNot) {
  EXPECT_EQ(Count(Busy([](double, double) { return 0.0; })), 0);
}

TEST_F(BusyPartTest, AWhiteObjectIsForItMovesTheStripes) {
  const cv::Mat busy = Busy([](double u, double v) { return InBox(u, v) ? 12.0 : 0.0; });
  EXPECT_EQ(cv::countNonZero(busy(cv::Rect(300, 200, 200, 200)) == 0), 0);
  EXPECT_LT(Count(busy), 400 * 400) << "the rest is left alone";
  EXPECT_EQ(cv::countNonZero(busy.colRange(0, 150)), 0);
}

TEST_F(BusyPartTest, AnObjectThatSwallowsTheLightIsForItsStripesAreMissing) {
  const cv::Mat busy = Busy([](double u, double v) { return InBox(u, v) ? NAN : 0.0; });
  EXPECT_EQ(cv::countNonZero(busy(cv::Rect(300, 200, 200, 200)) == 0), 0);
}

TEST_F(BusyPartTest, OneLaserIsEnoughToSeeIt) {
  const auto empty = [](double, double) { return 0.0; };
  const auto box = [](double u, double v) { return InBox(u, v) ? 12.0 : 0.0; };
  const cv::Mat busy =
      FindBusyPart({Surveyed(orders_, 0, empty), Surveyed(orders_, 1, box)}, orders_, unchanged_, {});
  EXPECT_EQ(cv::countNonZero(busy(cv::Rect(300, 200, 200, 200)) == 0), 0);
}

TEST_F(BusyPartTest, ADarkLaserOrAnotherLightMakesAllBusy) {
  LaserStripes dark;
  dark.laser = 1;
  const cv::Mat busy = FindBusyPart({dark}, orders_, unchanged_, {});
  EXPECT_EQ(Count(busy), 600 * 800);
  const cv::Mat other(600, 800, CV_8UC1, cv::Scalar(0));
  EXPECT_EQ(Count(FindBusyPart({}, orders_, other, {})), 600 * 800);
}

TEST_F(BusyPartTest, ChangedLightIsBusyWithItsSurroundings) {
  cv::Mat changed = unchanged_.clone();
  changed.at<std::uint8_t>(304, 404) = 0;
  const cv::Mat busy = FindBusyPart({}, orders_, changed, {.margin_cells = 1});
  EXPECT_EQ(Count(busy), 24 * 24);
  EXPECT_NE(busy.at<std::uint8_t>(304, 404), 0);
}

}  // namespace
}  // namespace dorsum
