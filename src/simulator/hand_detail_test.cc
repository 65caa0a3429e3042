// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_detail.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

SweptBody::Place OnTop(double s, double across = 0) {
  SweptBody::Place place = {};
  place.s = s;
  place.u = across;
  place.half_breadth = 10;
  place.half_depth = 9;
  place.v = 9 * std::sqrt(1 - across * across / 100);
  return place;
}

FingerDetail Finger(std::uint64_t seed) {
  Rng rng(seed);
  return {{{50, 10, 0.3, 7}, {76, 8.5, 0.2, 3}}, 88, 12, 13, rng};
}

TEST(FingerDetailTest, WrinklesLieOverTheJoint) {
  const FingerDetail detail = Finger(1);
  double deepest = 0, lowest = 0, elsewhere = 0;
  for (double s = 42; s <= 58; s += 0.1) {
    deepest = std::max(deepest, detail.At(OnTop(s)).crease);
    lowest = std::min(lowest, detail.At(OnTop(s)).height);
  }
  for (double s = 10; s <= 35; s += 0.1) elsewhere = std::max(elsewhere, detail.At(OnTop(s)).crease);
  EXPECT_GT(deepest, 0.5);
  EXPECT_LT(lowest, 0);
  EXPECT_GT(lowest, -0.6);
  EXPECT_EQ(elsewhere, 0);
}

TEST(FingerDetailTest, NailLiesOnTheBackOnly) {
  const FingerDetail detail = Finger(1);
  EXPECT_GT(detail.At(OnTop(94)).nail, 0.99);
  EXPECT_EQ(detail.At(OnTop(70)).nail, 0);
  EXPECT_LT(detail.At(OnTop(94, 7.5)).nail, 0.01);
  SweptBody::Place below = OnTop(94);
  below.v = -below.v;
  EXPECT_EQ(detail.At(below).nail, 0);
}

TEST(FingerDetailTest, HeightHasNoSteps) {
  const FingerDetail detail = Finger(2);
  for (double across : {-6.0, 0.0, 3.0}) {
    for (double s = 30; s < 105; s += 0.01) {
      EXPECT_LT(std::abs(detail.At(OnTop(s + 0.01, across)).height - detail.At(OnTop(s, across)).height),
                0.012)
          << s;
    }
  }
}

TEST(FingerDetailTest, PeopleDiffer) {
  double most = 0;
  for (double s = 42; s < 58; s += 0.1)
    most = std::max(most, std::abs(Finger(1).At(OnTop(s)).height - Finger(2).At(OnTop(s)).height));
  EXPECT_GT(most, 0.1);
}

TEST(DorsumDetailTest, TendonsAndKnucklesStandOut) {
  Rng rng(9);
  const HandShape shape = SampleHandShape(Sex::kMan, rng);
  const HandSkeleton skeleton = BuildSkeleton(shape, HandPose());
  const DorsumDetail detail(shape, skeleton);
  for (int i = 0; i < 4; ++i)
    EXPECT_GT(detail.Height(skeleton.fingers[i].mcp), 0.6 * shape.detail.knuckle[i]);
  for (int i = 1; i < 4; ++i) {
    const Eigen::Vector3d valley =
        0.5 * (skeleton.fingers[i - 1].mcp + skeleton.fingers[i].mcp) + Eigen::Vector3d(5, 0, 0);
    EXPECT_LT(detail.Height(valley), 0.5 * detail.Height(skeleton.fingers[i].mcp));
  }
  for (double x = -150; x < 100; x += 1) {
    for (double y = -50; y < 90; y += 1) {
      EXPECT_LT(std::abs(detail.Height({x, y, 30}) + detail.Vein({x, y, 30})), 7.0);
    }
  }
}

}  // namespace
}  // namespace dorsum
