// SPDX-License-Identifier: Apache-2.0
#include "speed/point_accuracy.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum::speed {
namespace {

using accuracy::TrueStripe;

// One stripe that moves by half a column from row to row, on the object or the backplane.
std::vector<TrueStripe> Slanted(int material) {
  std::vector<TrueStripe> out;
  for (int row = 0; row < 4; ++row) {
    out.push_back({.order = 2, .row = row, .u = 10.0 + 0.5 * row, .material = material, .irradiance = 0.5});
  }
  return out;
}

TEST(PointAccuracy, NearestInTheRowAndWhereThePointLies) {
  const auto errors =
      ErrorsAgainst(Slanted(3), {{10.1F, 0.0F}, {12.0F, 0.0F}, {10.8F, 1.4F}, {14.0F, 2.0F}, {11.3F, 3.0F}});
  ASSERT_EQ(errors.size(), 4U);
  EXPECT_NEAR(errors[0], 0.1, 1e-6);
  EXPECT_NEAR(errors[1], 0.1, 1e-6);  // at row 1.4, the stripe is at 10.7
  EXPECT_TRUE(std::isnan(errors[2]));
  EXPECT_NEAR(errors[3], -0.2, 1e-6);
  for (const double e : ErrorsAgainst(Slanted(3), {})) EXPECT_TRUE(std::isnan(e));
}

TEST(PointAccuracy, ComparesWhereBothFoundAndByMaterial) {
  DetectorComparison comparison;
  comparison.Add(Slanted(3), {{10.1F, 0.0F}, {10.6F, 1.0F}, {12.0F, 2.0F}}, {{10.2F, 0.0F}});
  comparison.Add(Slanted(0), {{10.0F, 0.0F}}, {{10.3F, 0.0F}, {10.8F, 1.0F}});
  auto dark = Slanted(3);
  for (TrueStripe& s : dark) s.irradiance = 0.0;
  comparison.Add(dark, {}, {});
  const Measured m = comparison.Summary();
  EXPECT_NEAR(m.at("object/ours/found"), 0.75, 1e-12);
  EXPECT_NEAR(m.at("object/theirs/found"), 0.25, 1e-12);
  EXPECT_NEAR(m.at("object/ours/rms_px"), 0.1, 1e-6);
  EXPECT_NEAR(m.at("object/theirs/rms_px"), 0.2, 1e-6);
  EXPECT_NEAR(m.at("backplane/ours/median_px"), 0.0, 1e-6);
  EXPECT_NEAR(m.at("backplane/theirs/median_px"), 0.3, 1e-6);
}

}  // namespace
}  // namespace dorsum::speed
