// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_checks.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.h"
#include "calibration/bundle_device_test.h"
#include "calibration/bundle_verdicts.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

BundleState Solved(const BundleFixture& device) {
  auto solution = SolveBundle(device.data, device.Start(), {}, {});
  EXPECT_TRUE(solution.ok());
  return solution->state;
}

// What the verdicts say when a check found this.
std::string VerdictOf(const BundleFixture& device, const std::function<void(BundleCalibration&)>& change,
                      const std::string& part) {
  BundleCalibration c;
  c.data = device.data;
  c.solution.state = device.truth;
  c.device.camera = device.camera;
  for (int k = 0; k < 2; ++k) {
    LaserGeometry laser;
    laser.laser = k;
    laser.fan = GeometryFromFan(device.truth.fans[static_cast<std::size_t>(k)]);
    c.device.lasers.push_back(laser);
  }
  c.pictures = {"stripesBg0", "laser0CalFurther", "laser0CalCloser", "heights/h25.0/stripesHand0",
                "stripesBg1", "laser1CalFurther", "laser1CalCloser", "heights/h25.0/stripesHand1"};
  c.laser_of_picture = {0, 0, 0, 0, 1, 1, 1, 1};
  c.assigned.assign(8, 1.0);
  c.pattern_mm = {0.0, 0.0};
  c.view_rms_px = ViewErrors(c.data, c.solution.state);
  change(c);
  for (const PartReport& report : JudgeBundle(c, {})) {
    if (report.part == part) return std::string(GradeName(report.grade)) + ", " + report.verdict;
  }
  return "(no such part)";
}

TEST(BundleChecks, AWrongHeightIsFound) {
  const BundleFixture device(48.6);  // 50 is given
  const auto checks = CheckHeights(device.data, Solved(device), {}, {});
  ASSERT_TRUE(checks.ok());
  ASSERT_EQ(checks->size(), 2U);
  EXPECT_NEAR((*checks)[0].fitted_mm, 48.6, 0.05);
  EXPECT_NEAR((*checks)[1].fitted_mm, 25.0, 0.1);
  EXPECT_TRUE(HeightIsWrong((*checks)[0], {}));
  EXPECT_FALSE(HeightIsWrong((*checks)[1], {}));
  const auto say = [&](BundleCalibration& c) { c.heights = *checks; };
  EXPECT_THAT(VerdictOf(device, say, "known heights"),
              HasSubstr("the calibration object is given as 50.0 mm, fits 48.6 mm"));
  EXPECT_EQ(VerdictOf(
                device, [](BundleCalibration&) {}, "known heights"),
            "good, all heights fit as they were given");
}

TEST(BundleChecks, ABentBoardIsFound) {
  const BundleFixture flat, bent(50.0, 25.0, 0.6);
  BundleProblemOptions options;
  options.corner_sd_px = 0.05;
  const auto of_flat = CheckBoard(flat.data, flat.Start(), options, {});
  const auto of_bent = CheckBoard(bent.data, bent.Start(), options, {});
  ASSERT_TRUE(of_flat.ok() && of_bent.ok());
  EXPECT_FALSE(BoardIsBent(*of_flat, {}));
  EXPECT_TRUE(BoardIsBent(*of_bent, {}));
  EXPECT_NEAR(of_bent->sag_mm, 0.6, 0.15);
  const auto say = [&](BundleCalibration& c) { c.board = *of_bent; };
  EXPECT_THAT(VerdictOf(bent, say, "chessboard"), HasSubstr("doubtful, the board is not flat"));
}

TEST(BundleChecks, ALaserThatMovedBetweenTheSeriesIsFound) {
  BundleFixture device;
  constexpr int kBox = 3;  // of the first laser
  std::erase_if(device.data.points, [](const SheetPoint& p) { return p.source == kBox; });
  DiffractedFan moved = device.fans[0];
  moved.origin.x() += 0.3;
  AddStripes(device.camera, moved, 0, 2, 25.0, kBox, &device.data);
  const auto checks = CheckSeries(device.data, Solved(device), {}, {});
  ASSERT_TRUE(checks.ok());
  EXPECT_EQ(checks->size(), 8U);
  const SeriesCheck* worst = nullptr;
  for (const SeriesCheck& check : *checks) {
    if (check.laser == 1) {
      EXPECT_LT(check.off_mm, 0.03) << check.source;
    }
    if (check.laser == 0 && (worst == nullptr || check.rest_sd < worst->rest_sd)) worst = &check;
  }
  ASSERT_NE(worst, nullptr);
  EXPECT_EQ(worst->source, kBox);
  EXPECT_NEAR(worst->off_mm, 0.3, 0.05);
  const auto say = [&](BundleCalibration& c) { c.left_out = {*worst}; };
  EXPECT_THAT(VerdictOf(device, say, "laser 0"),
              HasSubstr("laser 0 moved between the series: its stripes in heights/h25.0/stripesHand0"));
  EXPECT_THAT(VerdictOf(device, say, "laser 1"), HasSubstr("cones explain all stripes"));
}

TEST(BundleChecks, VerdictsSayWhichFormTheFanHas) {
  const BundleFixture device;
  const auto nothing = [](BundleCalibration&) {};
  EXPECT_THAT(VerdictOf(device, nothing, "laser 0"), HasSubstr("is flat"));
  EXPECT_THAT(VerdictOf(device, nothing, "laser 1"), HasSubstr("one cosine all along"));
}

TEST(BundleChecks, APatternCountsAndNoiseDoesNot) {
  Rng rng(5);
  std::vector<PatternPoint> noise, bent;
  for (int order = -8; order <= 8; ++order) {
    for (double y = -100.0; y < 100.0; y += 2.0) {
      const double r = 0.02 * rng.Normal();
      noise.push_back({order, y, 0.0, r});
      bent.push_back({order, y, 0.0, r + 0.1 * (std::pow(y / 100.0, 2) - 1.0 / 3.0)});
    }
  }
  EXPECT_LT(LeftPattern(noise), 0.004);
  EXPECT_NEAR(LeftPattern(bent), 0.03, 0.006);
  const BundleFixture device;
  const auto say = [](BundleCalibration& c) { c.pattern_mm[1] = 0.05; };
  EXPECT_THAT(VerdictOf(device, say, "laser 1"),
              HasSubstr("doubtful, the cones leave a pattern of 0.050 mm"));
}

TEST(BundleChecks, HeightUncertaintyGrowsWithTheNoise) {
  BundleFixture device;
  double last = 0.0;
  for (const double noise : {0.05, 0.2}) {
    BundleProblemOptions options;
    options.uncertainties = true;
    options.point_sd_px = noise;
    options.corner_sd_px = 2.0 * noise;
    const auto solution = SolveBundle(device.data, device.truth, options, {});
    ASSERT_TRUE(solution.ok());
    const double sd = HeightUncertainty(solution->state, solution->covariance, 0, -10, 10, 0.0, 80.0);
    EXPECT_GT(sd, 1.2 * last);
    EXPECT_LT(sd, 0.2);
    last = sd;
  }
}

}  // namespace
}  // namespace dorsum
