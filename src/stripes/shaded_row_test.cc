// SPDX-License-Identifier: Apache-2.0
#include "stripes/shaded_row.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stripes/shading_scene_test.h"

namespace dorsum {
namespace {

ShadedRow Whole(double strength, double width) {
  ShadedRow row;
  row.moved = true;
  row.strength = strength;
  row.profile.width = width;
  return row;
}

TEST(WholeRowsAround, AreTheNearestThatNothingCuts) {
  std::vector<ShadedRow> rows(100, Whole(0.0, 2.0));
  for (std::size_t i = 0; i < 50; ++i) rows[i].cut = true;
  for (std::size_t i = 50; i < 100; ++i) {
    rows[i] = Whole(i < 74 ? 1.0 + (i % 2 == 0 ? 0.2 : -0.2) : 9.0, i < 74 ? 2.5 : 7.0);
  }
  const auto whole = WholeRowsAround(rows, 40);
  ASSERT_TRUE(whole);
  EXPECT_NEAR(whole->strength, 1.0, 0.21);
  EXPECT_EQ(whole->width, 2.5);
  EXPECT_GE(whole->share, 0.1);
  EXPECT_LE(whole->share, 0.3);
  for (std::size_t i = 57; i < 100; ++i) rows[i].measures = false;
  EXPECT_FALSE(WholeRowsAround(rows, 40)) << "seven rows say too little";
}

// One flank of a stripe whose middle lies 1 px beyond the outline.
TEST(FitShadedRows, WholeRowsPlaceACentreBeyondTheOutline) {
  const ShadedScene scene([](double, double) { return 0.8; }, {5, 5, 84, 150});  // to 89 px; stripe 4 at 90.3
  const IndexedStripes stripes = scene.Stripes([](int k) { return k < 5; });
  const SurfaceBrightness bright(scene.led, scene.mask, stripes, {});
  const LaserPicture picture{scene.lines, NoiseModel{1.1, 0.0, 0.0}};
  const std::vector<std::vector<float>> columns(160);
  const ProfileFitOptions fit;
  const ShadedRowOptions options;
  const auto fit_row = [&](const StripePoint& point, const std::optional<WholeRows>& whole) {
    return FitShadedRows({{point, ShadedScene::kWidth, whole}}, bright, picture, columns, fit, options)
        .front();
  };
  StripePoint inner;
  inner.u = static_cast<float>(ShadedScene::Centre(3));
  inner.v = 80.0F;
  const ShadedRow clean = fit_row(inner, std::nullopt);
  ASSERT_TRUE(clean.moved && clean.strength);
  EXPECT_FALSE(clean.cut);
  StripePoint outer = inner;
  outer.u = static_cast<float>(ShadedScene::Centre(4) - 2.0);
  double miss = 0.0;
  int rows = 0;
  for (int v = 40; v < 120; ++v) {
    outer.v = static_cast<float>(v);
    const ShadedRow cut = fit_row(outer, WholeRows{*clean.strength, 0.1, ShadedScene::kWidth});
    EXPECT_TRUE(cut.cut);
    if (!cut.moved) continue;
    miss += cut.profile.u - ShadedScene::Centre(4);
    ++rows;
  }
  ASSERT_GT(rows, 60);
  EXPECT_LT(std::abs(miss / rows), 0.5);
}

}  // namespace
}  // namespace dorsum
