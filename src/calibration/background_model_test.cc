// SPDX-License-Identifier: Apache-2.0
#include "calibration/background_model.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

TEST(PlanesThroughGrating, EachPlaneHoldsTheGratingAndItsLine) {
  const Eigen::Vector3d grating(20.0, 0.0, 300.0);
  const std::vector<BackgroundLine> lines = {{.order = -1, .at = 11.0, .slope = 0.02},
                                             {.order = 0, .at = 20.0, .slope = 0.0},
                                             {.order = 1, .at = 29.5, .slope = -0.03}};
  const auto planes = PlanesThroughGrating(grating, lines);
  ASSERT_EQ(planes.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(planes[i].order, lines[i].order);
    EXPECT_NEAR(planes[i].plane.normal.norm(), 1.0, 1e-12);
    EXPECT_GT(planes[i].plane.normal.x(), 0.0) << "towards growing order";
    EXPECT_NEAR(planes[i].plane.SignedDistance(grating), 0.0, 1e-9);
    for (const double y : {-100.0, 0.0, 80.0}) {
      EXPECT_NEAR(planes[i].plane.SignedDistance({lines[i].at + lines[i].slope * y, y, 0.0}), 0.0, 1e-9);
    }
  }
}

TEST(PlanesThroughGrating, MissingOrdersAreInterpolated) {
  const Eigen::Vector3d grating(20.0, 0.0, 300.0);
  const auto planes = PlanesThroughGrating(
      grating, {{.order = 2, .at = 36.0, .slope = 0.01}, {.order = 5, .at = 66.0, .slope = 0.04}});
  ASSERT_EQ(planes.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(planes[static_cast<std::size_t>(i)].order, 2 + i);
    const double at = 36.0 + 10.0 * i, slope = 0.01 + 0.01 * i;
    EXPECT_NEAR(planes[static_cast<std::size_t>(i)].plane.SignedDistance({at + 50.0 * slope, 50.0, 0.0}), 0.0,
                1e-9);
  }
}

// Stripes of 30 mm spacing on the backplane that lean by 0.02, one of them missing.
class ModelBackgroundTest : public ::testing::Test {
 protected:
  cv::Mat Draw(const std::vector<int>& orders) const {
    cv::Mat image(camera_.height, camera_.width, CV_8UC3, cv::Scalar(10, 12, 10));
    for (int v = 0; v < image.rows; ++v) {
      const double y = (camera_.cy - v) / 2.0;  // 2 px per mm
      for (int u = 0; u < image.cols; ++u) {
        double green = 12.0;
        for (const int m : orders) {
          const double at = camera_.cx + 2.0 * (15.0 + 30.0 * m + 0.02 * y);
          green += (m == 0 ? 180.0 : 100.0) * std::exp(-0.5 * std::pow((u - at) / 2.5, 2));
        }
        image.at<cv::Vec3b>(v, u)[1] = cv::saturate_cast<uchar>(green);
      }
    }
    return image;
  }
  Camera camera_ = TestCamera();
  std::vector<double> known_ = {-105.0, -75.0, -45.0, -15.0, 15.0, 45.0, 75.0, 105.0};
};

TEST_F(ModelBackgroundTest, LinesAndReferencesAreThoseOfTheStripesOverAGap) {
  const std::vector<int> orders = {-4, -3, -2, -1, 0, 2, 3};
  const auto model = ModelBackground(Draw(orders), 1, camera_, 15.0, known_, {}, {});
  ASSERT_TRUE(model.ok()) << model.error().message;
  ASSERT_EQ(model->lines.size(), orders.size());
  ASSERT_EQ(model->reference.size(), orders.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const BackgroundLine& line = model->lines[i];
    EXPECT_EQ(line.order, orders[i]);
    EXPECT_NEAR(line.at, 15.0 + 30.0 * orders[i], 0.5);
    EXPECT_NEAR(line.slope, 0.02, 0.003);
    EXPECT_LT(line.rms_mm, 0.3);
    const ReferenceStripe& r = model->reference[i];
    EXPECT_EQ(r.order, orders[i]);
    EXPECT_NEAR(r.ColumnAt(240.0), camera_.cx + 2.0 * (15.0 + 30.0 * orders[i]), 1.0);
    EXPECT_NEAR(r.PeakAt(240.0), orders[i] == 0 ? 192.0 : 112.0, 3.0);
    EXPECT_TRUE(r.Covers(20.0) && r.Covers(460.0));
  }
  EXPECT_EQ(model->stripes.laser, 1);
}

TEST_F(ModelBackgroundTest, TooFewStripesAreNamed) {
  const auto model = ModelBackground(Draw({0, 1}), 3, camera_, 15.0, known_, {}, {});
  ASSERT_FALSE(model.ok());
  EXPECT_EQ(model.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(model.error().message, HasSubstr("stripesBg3"));
}

}  // namespace
}  // namespace dorsum
