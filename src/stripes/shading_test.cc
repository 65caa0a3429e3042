// SPDX-License-Identifier: Apache-2.0
#include "stripes/shading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stripes/shading_scene_test.h"

namespace dorsum {
namespace {

const NoiseModel kNoise{1.1, 0.0, 0.0};

LaserStripes Fit(const ShadedScene& scene, IndexedStripes stripes, int threads = 1) {
  Context context;
  context.threads = threads;
  const SurfaceBrightness bright(scene.led, scene.mask, stripes, {});
  FitOnShadedSurface(bright, {{scene.lines, kNoise}}, {}, {}, context, &stripes);
  return stripes.lasers[0];
}

double MeanMiss(const LaserStripes& stripes) {
  double sum = 0.0;
  for (const StripePoint& p : stripes.points) {
    const int order = *stripes.segments[static_cast<std::size_t>(p.segment)].order;
    sum += static_cast<double>(p.u) - ShadedScene::Centre(order);
  }
  return sum / static_cast<double>(stripes.points.size());
}

TEST(Shading, TakesThePullOfABrightnessSlopeAway) {
  const auto fading = [](double u, double) { return std::exp(-0.03 * std::abs(u - 100.0)); };
  const ShadedScene scene(fading, {5, 5, 190, 150});
  const auto left = [](int k) { return k == 2 || k == 3; };
  const double pull = 0.03 * ShadedScene::kWidth * ShadedScene::kWidth;  // 0.17 px towards the middle
  const LaserStripes fitted = Fit(scene, scene.Stripes(left, pull));
  EXPECT_EQ(fitted.points.size(), 280U);
  EXPECT_NEAR(MeanMiss(fitted), 0.0, 0.03);
}

TEST(Shading, AnOutlineBesideTheStripeLeavesItsCentre) {
  // Stripe 3 at 70.3 px; the object ends 2.5 px further right.
  const ShadedScene scene([](double, double) { return 0.8; }, {5, 5, 68, 150});
  const LaserStripes fitted = Fit(scene, scene.Stripes([](int k) { return k > 0 && k < 4; }));
  double miss = 0.0;
  int count = 0;
  for (const StripePoint& p : fitted.points) {
    if (*fitted.segments[static_cast<std::size_t>(p.segment)].order != 3) continue;
    miss += static_cast<double>(p.u) - ShadedScene::Centre(3);
    ++count;
  }
  EXPECT_GT(count, 100);
  EXPECT_NEAR(miss / count, 0.0, 0.2);  // one flank alone
}

TEST(Shading, ACentreOnTheDarkSideOfAStepIsNoMeasurement) {
  const ShadedScene scene([](double u, double) { return u < 108.0 ? 0.9 : 0.06; }, {5, 5, 190, 150});
  const LaserStripes fitted = Fit(scene, scene.Stripes([](int k) { return k > 1 && k < 6; }, -2.0));
  int at_the_step = 0, elsewhere = 0;
  for (const StripePoint& p : fitted.points) {
    const int order = *fitted.segments[static_cast<std::size_t>(p.segment)].order;
    (order == 5 ? at_the_step : elsewhere) += 1;  // at 110.3 px
  }
  EXPECT_EQ(elsewhere, 3 * 140);
  EXPECT_LT(at_the_step, 14);
}

// An edge that crosses a stripe at a slant cuts one flank away over many rows; what is left looks like a
// stripe that bends along the edge.
TEST(Shading, AStripeThatASlantedEdgeCutsStaysStraight) {
  // Stripe 5, at 110.3 px, meets the edge in row 80.
  const auto edge = [](double v) { return 110.3 + 0.12 * (80.0 - v); };
  const ShadedScene scene([&](double u, double v) { return u > edge(v) ? 0.9 : 0.08; }, {5, 5, 190, 150});
  IndexedStripes stripes = scene.Stripes([](int k) { return k > 4 && k < 9; });
  for (StripePoint& p : stripes.lasers[0].points) {
    if (p.u < 115.0F)
      p.u += static_cast<float>(std::max(0.0, 1.5 - 0.5 * (static_cast<double>(p.u) - edge(p.v))));
  }
  const LaserStripes fitted = Fit(scene, stripes);
  double miss = 0.0, beyond = 0.0, cut = 0.0;
  for (const StripePoint& p : fitted.points) {
    if (*fitted.segments[static_cast<std::size_t>(p.segment)].order != 5) continue;
    const double inside = 110.3 - edge(static_cast<double>(p.v));
    if (inside < -0.5) beyond += 1.0;
    if (inside < 0.5 || inside > 3.0) continue;
    cut += 1.0;
    miss += static_cast<double>(p.u) - ShadedScene::Centre(5);
  }
  EXPECT_GT(cut, 10.0);
  EXPECT_LT(std::abs(miss / cut), 0.25);
  EXPECT_LT(beyond, 3.0);
}

TEST(Shading, RowsThatAreFarTooDarkAreOnlyAFlank) {
  ShadedScene scene([](double, double) { return 0.8; }, {5, 5, 190, 150});
  IndexedStripes stripes = scene.Stripes([](int k) { return k > 1 && k < 6; });
  LaserStripes& one = stripes.lasers[0];
  for (std::size_t i = 0; i < 20; ++i) {
    one.points[i].peak *= 0.2F;
    auto* row = scene.lines.ptr<std::uint8_t>(static_cast<int>(one.points[i].v));
    for (int u = 30; u < 70; ++u) row[u] = static_cast<std::uint8_t>(4 + (row[u] - 4) / 5);
  }
  const LaserStripes fitted = Fit(scene, stripes);
  EXPECT_EQ(fitted.points.size(), 4U * 140U - 20U);
  EXPECT_EQ(fitted.points.front().v, 30.0F);
}

TEST(Shading, StripesWithoutAnOrderStayAsTheyAre) {
  const ShadedScene scene([](double u, double) { return std::exp(-0.02 * u); }, {5, 5, 190, 150});
  IndexedStripes stripes = scene.Stripes([](int k) { return k < 4; });
  for (StripeSegment& s : stripes.lasers[0].segments) s.order.reset();
  const LaserStripes before = stripes.lasers[0], after = Fit(scene, stripes);
  ASSERT_EQ(after.points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) EXPECT_EQ(after.points[i].u, before.points[i].u);
}

TEST(Shading, SameBytesAtAnyNumberOfThreads) {
  const ShadedScene scene([](double u, double) { return std::exp(-0.01 * u); }, {5, 5, 190, 150});
  const IndexedStripes stripes = scene.Stripes([](int) { return true; }, 0.1);
  const LaserStripes one = Fit(scene, stripes, 1), four = Fit(scene, stripes, 4);
  ASSERT_EQ(one.points.size(), four.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    EXPECT_EQ(one.points[i].u, four.points[i].u);
    EXPECT_EQ(one.points[i].sd_px, four.points[i].sd_px);
  }
}

}  // namespace
}  // namespace dorsum
