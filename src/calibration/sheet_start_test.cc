// SPDX-License-Identifier: Apache-2.0
#include "calibration/sheet_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration/bundle_device_test.h"

namespace dorsum {
namespace {

// Stripes of all orders but those left out; `brightest` is the order with the most light.
LaserStripes Stripes(const Camera& camera, const DiffractedFan& fan, double z, int brightest,
                     const std::vector<int>& without = {}) {
  LaserStripes stripes;
  stripes.laser = 2;
  for (int order = -9; order <= 9; ++order) {
    if (std::find(without.begin(), without.end(), order) != without.end()) continue;
    StripeSegment segment;
    segment.first = static_cast<std::int32_t>(stripes.points.size());
    for (int v = 0; v < camera.height; v += 2) {
      const auto u = SheetColumn(camera, fan, order, v, z);
      if (!u) continue;
      StripePoint p;
      p.u = static_cast<float>(*u);
      p.v = static_cast<float>(v);
      p.peak = order == brightest ? 200.0F : 100.0F - 5.0F * static_cast<float>(std::abs(order));
      p.segment = static_cast<std::int32_t>(stripes.segments.size());
      stripes.points.push_back(p);
      ++segment.count;
    }
    if (segment.count > 0) stripes.segments.push_back(segment);
  }
  return stripes;
}

TEST(SheetStart, FindsTheGratingFromTwoPlanes) {
  const Camera camera = BundleCamera();
  for (const double tilt : {-0.08, 0.0, 0.06}) {
    const DiffractedFan fan = BundleFan(4.0, tilt, FanForm::kFlat);
    const auto start = EstimateSheets(camera, Stripes(camera, fan, 0.0, 0), Stripes(camera, fan, 50.0, 0),
                                      50.0, std::nullopt, {});
    ASSERT_TRUE(start.ok()) << start.error().message;
    EXPECT_NEAR(start->fan.origin.x(), fan.origin.x(), 2.0);
    EXPECT_NEAR(start->fan.origin.z(), fan.origin.z(), 6.0);
    EXPECT_NEAR(start->fan.step, fan.step, 0.02 * fan.step);
    EXPECT_EQ(start->central_shift, 0);
  }
}

TEST(SheetStart, MissingOrdersAndAnotherBrightestStripeDoNotMislead) {
  const Camera camera = BundleCamera();
  const DiffractedFan fan = BundleFan(4.0, 0.02, FanForm::kConical);
  const auto start = EstimateSheets(camera, Stripes(camera, fan, 0.0, 0, {3, 4}),
                                    Stripes(camera, fan, 50.0, 2, {-1, 5}), 50.0, std::nullopt, {});
  ASSERT_TRUE(start.ok()) << start.error().message;
  EXPECT_EQ(start->central_shift, 2);
  EXPECT_NEAR(start->fan.origin.z(), fan.origin.z(), 6.0);
}

TEST(SheetStart, TheDrawnLineDecidesWhichStripeIsCentral) {
  const Camera camera = BundleCamera();
  const DiffractedFan fan = BundleFan(4.0, 0.0, FanForm::kFlat);
  const LaserStripes far = Stripes(camera, fan, 0.0, 1), near = Stripes(camera, fan, 50.0, 0);
  const std::vector<StripeLine> lines = LinesOnPlane(camera, far, 0.0, {});
  ASSERT_GE(lines.size(), 10U);
  LaserGeometry laser;
  laser.fan = fan;
  const Eigen::Vector2d origin = Project(camera, {0.0, 0.0, 0.0});
  const auto central = OrderAtHeight(camera, laser, SheetModel::kCone, origin, 0.0);
  ASSERT_TRUE(central.has_value());
  // x of order 0 at y = 0: spacing is about 15 mm.
  const double x = -15.0 * central.value_or(0.0) + 0.5;
  const auto start = EstimateSheets(camera, far, near, 50.0, x, {});
  ASSERT_TRUE(start.ok());
  EXPECT_NEAR(start->fan.origin.z(), fan.origin.z(), 6.0);
  EXPECT_NEAR(start->fan.tilt, -0.012, 0.01) << "one order beside would be a lean of 0.04";
}

TEST(SheetStart, TooFewStripesAreAnErrorThatNamesThePicture) {
  const Camera camera = BundleCamera();
  const DiffractedFan fan = BundleFan(4.0, 0.0, FanForm::kFlat);
  LaserStripes none;
  none.laser = 2;
  const auto start = EstimateSheets(camera, none, Stripes(camera, fan, 50.0, 0), 50.0, std::nullopt, {});
  ASSERT_FALSE(start.ok());
  EXPECT_EQ(start.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(start.error().message, ::testing::HasSubstr("stripesBg2"));
}

// Where Closer and Further are swapped, the nearer picture shows the backplane.
TEST(SheetStart, ANearerPictureOfTheBackplaneIsAnError) {
  const Camera camera = BundleCamera();
  const DiffractedFan fan = BundleFan(4.0, 0.0, FanForm::kFlat);
  const LaserStripes backplane = Stripes(camera, fan, 0.0, 0);
  const auto start = EstimateSheets(camera, backplane, backplane, 50.0, std::nullopt, {});
  ASSERT_FALSE(start.ok());
  EXPECT_THAT(start.error().message, ::testing::HasSubstr("swapped"));
}

}  // namespace
}  // namespace dorsum
