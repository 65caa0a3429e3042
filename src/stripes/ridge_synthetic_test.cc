// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "stripes/pooling.h"
#include "stripes/ridge.h"
#include "stripes/synthetic_stripes_test.h"

namespace dorsum {
namespace {

// A quarter of the bench's image, with the same spacings.
SyntheticStripeDesign Small(int stripes, double peak, double noise_sd) {
  SyntheticStripeDesign design;
  design.width = 800;
  design.height = 400;
  design.stripes = stripes / 2;
  design.peak = peak;
  design.noise_sd = noise_sd;
  return design;
}

SyntheticScore Score(const SyntheticStripeDesign& design) {
  const SyntheticStripes scene = RenderSyntheticStripes(design);
  const LaserStripes found = FindRidges(scene.image, cv::Mat(), 0, {}, {});
  return ScoreSyntheticStripes(scene, found);
}

TEST(RidgeSynthetic, FortyCleanStripesAreAllFound) {
  const SyntheticScore score = Score(Small(40, 200.0, 1.0));
  EXPECT_GT(score.recall, 0.99);
  EXPECT_LT(score.rmse_px, 0.1);
  EXPECT_LT(score.false_share, 0.005);
  EXPECT_LT(score.Efficiency(), 1.2);
}

TEST(RidgeSynthetic, DimStripesMeetTheBoundAndSayHowSureTheyAre) {
  const SyntheticScore score = Score(Small(40, 60.0, 2.0));
  EXPECT_GT(score.recall, 0.97);
  EXPECT_LT(score.Efficiency(), 1.25);
  EXPECT_GT(score.sigma_ratio, 0.85);
  EXPECT_LT(score.sigma_ratio, 1.15);
}

TEST(RidgeSynthetic, ClippedTopsDoNotPullTheCentre) {
  const SyntheticScore score = Score(Small(80, 400.0, 1.0));
  EXPECT_GT(score.recall, 0.99);
  EXPECT_LT(score.rmse_px, 0.1);
  EXPECT_LT(score.false_share, 0.005);
}

TEST(RidgeSynthetic, PoolingAlongTheStripePays) {
  const SyntheticStripes scene = RenderSyntheticStripes(Small(40, 60.0, 2.0));
  const LaserStripes rows = FindRidges(scene.image, cv::Mat(), 0, {}, {});
  const SyntheticScore single = ScoreSyntheticStripes(scene, rows);
  const SyntheticScore pooled = ScoreSyntheticStripes(scene, PoolAlongStripes(rows, {}, {}));
  EXPECT_LT(pooled.rmse_px, 0.5 * single.rmse_px);
  EXPECT_GT(pooled.sigma_ratio, 0.6);
  EXPECT_LT(pooled.sigma_ratio, 1.3);
}

}  // namespace
}  // namespace dorsum
