// SPDX-License-Identifier: Apache-2.0
#include "surface/rim.h"

#include <cmath>

#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"

namespace dorsum {
namespace {

// A finger of radius 9 mm along x.
double Finger(double /*x*/, double y) {
  return std::abs(y) < 9.0 ? 10.0 + std::sqrt(81.0 - y * y) : std::nan("");
}
double Slab(double x, double y) { return std::abs(x) < 40.0 && std::abs(y) < 15.0 ? 20.0 : std::nan(""); }

TEST(RimTest, AFingersFlankFallsLikeARoot) {
  const Scene s = ScanBody(Finger);
  const Outline outline(s.mask, 4);
  const Rim rim(SamplesOf(s.points), outline, {.mm_per_px = 0.48});
  // Near the outline sqrt(r^2 - y^2) is sqrt(2 r d), d the distance to it.
  const double v = 240.0 - 8.6 / 0.48;
  const double d = 0.48 * outline.Distance(320.0, v);
  // The prior draws it towards zero; the plate takes the rest.
  const double amplitude = rim.Height(320.0, v) / std::sqrt(d);
  EXPECT_GT(amplitude, 0.5 * std::sqrt(18.0));
  EXPECT_LT(amplitude, 1.3 * std::sqrt(18.0));
  EXPECT_EQ(rim.Height(320.0, 100.0), 0.0F);
}

TEST(RimTest, ASharpEdgeHasNoRim) {
  const Scene s = ScanBody(Slab);
  const Outline outline(s.mask, 4);
  const Rim rim(SamplesOf(s.points), outline, {.mm_per_px = 0.48});
  for (double v = 205.0; v < 275.0; v += 5.0) EXPECT_NEAR(rim.Height(320.0, v), 0.0, 0.05);
}

}  // namespace
}  // namespace dorsum
