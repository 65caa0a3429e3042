// SPDX-License-Identifier: Apache-2.0
#include "surface/stripe_agreement.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"

namespace dorsum {
namespace {

double Slab(double x, double y) {
  return std::abs(x) < 60.0 && std::abs(y) < 20.0 ? 20.0 + 0.1 * x : std::nan("");
}

class StripeAgreementTest : public ::testing::Test {
 protected:
  // Lifts the points of some stripes as a wrong order would.
  template <class Which>
  std::vector<bool> Lift(Scene* s, const Which& which) {
    std::vector<bool> lifted;
    for (SurfacePoint& p : s->points) {
      lifted.push_back(which(p));
      if (lifted.back()) p.position.z() += 41.0;
    }
    return lifted;
  }
  static std::vector<bool> Find(const Scene& s) {
    return FindMisplaced(s.points, Outline(s.mask, 4), {.mm_per_px = 0.48});
  }
};

TEST_F(StripeAgreementTest, AWrongStripeBetweenRightOnesIsFound) {
  Scene s = ScanBody(Slab);
  const std::vector<bool> wrong =
      Lift(&s, [](const SurfacePoint& p) { return p.laser == 0 && p.order == 20; });
  ASSERT_GT(std::count(wrong.begin(), wrong.end(), true), 50);
  EXPECT_EQ(Find(s), wrong);
}

TEST_F(StripeAgreementTest, HalfAWrongStripeAtTheEndIsFound) {
  Scene s = ScanBody(Slab);
  const float last = std::max_element(s.points.begin(), s.points.end(), [](const auto& a, const auto& b) {
                       return a.u < b.u;
                     })->u;
  const std::vector<bool> wrong =
      Lift(&s, [&](const SurfacePoint& p) { return p.u > last - 4.0F && p.v < 240.0F; });
  ASSERT_GT(std::count(wrong.begin(), wrong.end(), true), 20);
  EXPECT_EQ(Find(s), wrong);
}

TEST_F(StripeAgreementTest, AllOrdersOfOneLaserWrongAmongFourAreFound) {
  Scene s = ScanBody(Slab, 4);
  const std::vector<bool> wrong = Lift(&s, [](const SurfacePoint& p) { return p.laser == 2; });
  EXPECT_EQ(Find(s), wrong);
}

TEST_F(StripeAgreementTest, ASteppedBodyIsRight) {
  const Scene s = ScanBody([](double x, double y) { return Slab(x, y) + (x > 10.0 ? 30.0 : 0.0); });
  const std::vector<bool> found = Find(s);
  EXPECT_EQ(std::count(found.begin(), found.end(), true), 0);
}

}  // namespace
}  // namespace dorsum
