// SPDX-License-Identifier: Apache-2.0
#include "stripes/surface_brightness.h"

#include <vector>

#include <gtest/gtest.h>

#include "stripes/shading_scene_test.h"

namespace dorsum {
namespace {

const cv::Rect kObject(5, 5, 190, 150);

bool All(int) { return true; }

TEST(SurfaceBrightness, FollowsThePicture) {
  const ShadedScene scene([](double u, double) { return std::exp(-0.01 * u); }, kObject);
  const SurfaceBrightness bright(scene.led, scene.mask, scene.Stripes(All), {});
  std::vector<float> gain(200, -1.0F);
  bright.Along(90.0, 80, 80, 100, &gain[80]);
  EXPECT_EQ(gain[79], -1.0F);
  EXPECT_EQ(gain[101], -1.0F);
  for (const int u : {80, 90, 100}) {
    EXPECT_NEAR(gain[static_cast<std::size_t>(u)], std::exp(-0.01 * (u - 90)), 0.02) << u;
  }
}

TEST(SurfaceBrightness, IsNothingOffTheObjectAndInItsMargin) {
  const ShadedScene scene([](double, double) { return 0.7; }, {60, 5, 100, 150});
  const SurfaceBrightness bright(scene.led, scene.mask, scene.Stripes([](int k) { return k > 2 && k < 7; }),
                                 {});
  std::vector<float> gain(200, -1.0F);
  bright.Along(64.0, 80, 55, 75, &gain[55]);
  for (std::size_t u = 55; u < 61; ++u) EXPECT_EQ(gain[u], 0.0F);
  for (std::size_t u = 63; u < 76; ++u) EXPECT_NEAR(gain[u], 1.0F, 0.05F);
  bright.Along(20.0, 80, 10, 30, &gain[10]);  // far off the object: nothing is known
  for (std::size_t u = 10; u < 31; ++u) EXPECT_EQ(gain[u], 1.0F);
}

// A lamp's shadow darkens the picture at its edge, and the stripes cross it without a change.
TEST(SurfaceBrightness, AShadowThatTheStripesDoNotShowIsNone) {
  ShadedScene scene([](double, double) { return 0.8; }, kObject);
  IndexedStripes stripes;
  stripes.lasers.resize(1);
  std::vector<StripePoint> points;
  for (int v = 10; v < 150; ++v) {
    for (int u = 5; u < 195; ++u) {
      const double depth = 1.0 / (1.0 + std::exp(-0.5 * (u - 100.0 - 0.5 * (v - 80.0))));
      scene.led.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(160.0 * (1.0 - 0.5 * depth));
    }
  }
  const SurfaceBrightness with(scene.led, scene.mask, scene.Stripes(All), {});
  const SurfaceBrightness without(scene.led, scene.mask, stripes, {});
  std::vector<float> shadow(200), fooled(200);
  with.Along(90.3, 61, 84, 96, &shadow[84]);  // where the shadow's edge crosses a stripe
  without.Along(90.3, 61, 84, 96, &fooled[84]);
  EXPECT_LT(fooled[96] / fooled[84], 0.65F);
  EXPECT_GT(shadow[96] / shadow[84], 0.68F);  // one laser alone shows it here
}

TEST(SurfaceBrightness, TellsHowDarkAPointIsForItsStripe) {
  const ShadedScene scene([](double u, double) { return u < 100.0 ? 0.8 : 0.4; }, kObject);
  const IndexedStripes stripes = scene.Stripes(All);
  const SurfaceBrightness bright(scene.led, scene.mask, stripes, {});
  StripePoint p = stripes.lasers[0].points[300];
  const double strength = bright.StrengthOf(0, 2).value_or(9.0);
  EXPECT_NEAR(bright.RatioOf(strength, p, 2.0).value_or(9.0), 0.0, 0.05);
  p.peak *= 0.5F;
  EXPECT_NEAR(bright.RatioOf(strength, p, 2.0).value_or(9.0), std::log(0.5), 0.05);
  EXPECT_NEAR(bright.StrengthOf(0, 12).value_or(9.0), strength - 0.2, 0.05);  // beyond the last order
  EXPECT_FALSE(bright.StrengthOf(7, 2).has_value());
  p.u = 1.0F;
  EXPECT_FALSE(bright.RatioOf(strength, p, 2.0).has_value());
}

TEST(SurfaceBrightness, NoObjectIsNoHarm) {
  const cv::Mat black(40, 40, CV_8UC1, cv::Scalar(0));
  const SurfaceBrightness bright(black, black, {}, {});
  std::vector<float> gain(40, -1.0F);
  bright.Along(20.0, 20, 10, 30, &gain[10]);
  EXPECT_EQ(gain[20], 1.0F);
}

}  // namespace
}  // namespace dorsum
