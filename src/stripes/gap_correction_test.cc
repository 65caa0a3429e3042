// SPDX-License-Identifier: Apache-2.0
#include "stripes/gap_correction.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "stripes/stripe_layout_test.h"

namespace dorsum {
namespace {

// Stripes 20 px apart on the backplane.
double Backplane(float u, float /*v*/) { return u / 20.0; }

std::vector<int> Levels(const StripeTree& tree) {
  std::vector<int> levels;
  levels.reserve(tree.nodes.size());
  for (const StripeNode& node : tree.nodes) levels.push_back(node.level);
  return levels;
}

TEST(GapCorrection, WithoutAGapNothingChanges) {
  LaserStripes stripes;
  for (int i = 0; i < 6; ++i) AddStripe(&stripes, 0, 50, 10.0 + 20.0 * i);
  StripeTree tree = BuildStripeTree(&stripes, 4);
  EXPECT_EQ(CorrectGaps(stripes, Backplane, {}, &tree), 0);
  EXPECT_EQ(Levels(tree), (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(GapCorrection, AMissingStripeIsCountedAndTheChildrenFollow) {
  LaserStripes stripes;
  for (const double u : {10.0, 30.0, 70.0, 90.0, 150.0, 170.0}) AddStripe(&stripes, 0, 50, u);
  StripeTree tree = BuildStripeTree(&stripes, 4);
  ASSERT_EQ(Levels(tree), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(CorrectGaps(stripes, Backplane, {}, &tree), 2);
  EXPECT_EQ(Levels(tree), (std::vector<int>{0, 1, 3, 4, 7, 8}));
}

TEST(GapCorrection, ASlopeThatWidensTheStepIsNoGap) {
  LaserStripes stripes;
  for (const double u : {10.0, 38.0, 66.0}) AddStripe(&stripes, 0, 50, u);  // 1.4 usual spacings
  StripeTree tree = BuildStripeTree(&stripes, 4);
  EXPECT_EQ(CorrectGaps(stripes, Backplane, {}, &tree), 0);
  EXPECT_EQ(Levels(tree), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(CorrectGaps(stripes, Backplane, {.max_spacings = 1.3}, &tree), 0) << "1.4 rounds to one step";
}

TEST(GapCorrection, ARootInOtherRowsIsCountedFromTheNearestStripe) {
  LaserStripes stripes;
  for (int i = 0; i < 4; ++i) AddStripe(&stripes, 0, 50, 10.0 + 20.0 * i);
  AddStripe(&stripes, 60, 100, 50.0);  // below the stripe at 50
  AddStripe(&stripes, 60, 100, 90.0);  // one missing between
  AddStripe(&stripes, 60, 100, 110.0);
  StripeTree tree = BuildStripeTree(&stripes, 4);
  ASSERT_EQ(tree.roots.size(), 2U);
  CorrectGaps(stripes, Backplane, {}, &tree);
  EXPECT_EQ(Levels(tree), (std::vector<int>{0, 1, 2, 3, 2, 4, 5}));
}

TEST(GapCorrection, APieceOfABrokenSlantedStripeKeepsTheStripesIndex) {
  // The last stripe leans left by more than half a spacing and is broken; its lower piece stands alone in its
  // rows, and further left on the whole than the largest tree's stripes suggest.
  const auto leaning = [](int row) { return 90.0 - 0.2 * std::max(0, row - 50); };
  LaserStripes stripes;
  AddStripe(&stripes, 105, 150, leaning);
  for (int i = 0; i < 4; ++i) AddStripe(&stripes, 0, 100, 10.0 + 20.0 * i);
  AddStripe(&stripes, 0, 100, leaning);
  StripeTree tree = BuildStripeTree(&stripes, 4);
  CorrectGaps(stripes, Backplane, {}, &tree);
  EXPECT_EQ(Levels(tree), (std::vector<int>{4, 0, 1, 2, 3, 4}));
}

TEST(GapCorrection, TheUsualDistanceIsTheMedianSoThatARaggedEndDoesNotCount) {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 50, [](int row) { return row < 8 ? 0.0 : 20.0; });
  AddStripe(&stripes, 0, 50, 40.0);
  StripeTree tree = BuildStripeTree(&stripes, 4);
  EXPECT_EQ(CorrectGaps(stripes, Backplane, {}, &tree), 0);
  EXPECT_EQ(Levels(tree), (std::vector<int>{0, 1}));
}

TEST(GapCorrection, AParentOnASlopeIsCorrectedBeforeItsChild) {
  // The middle stripe runs far to the right below its child, so that on the whole it lies right of it.
  LaserStripes stripes;
  AddStripe(&stripes, 0, 120, 10.0);
  AddStripe(&stripes, 0, 120,
            [](int row) { return row < 50 ? 50.0 : 50.0 + 2.0 * (row - 50); });  // one missing before
  AddStripe(&stripes, 0, 40, 70.0);
  StripeTree tree = BuildStripeTree(&stripes, 4);
  ASSERT_EQ(Levels(tree), (std::vector<int>{0, 1, 2}));
  CorrectGaps(
      stripes, [](float u, float v) { return (v < 50.0F ? u : std::min(u, 130.0F)) / 20.0; }, {}, &tree);
  EXPECT_EQ(Levels(tree)[2], Levels(tree)[1] + 1);
  EXPECT_GT(Levels(tree)[1], 1);
}

TEST(GapCorrection, NoStripesAreNoTrouble) {
  LaserStripes stripes;
  StripeTree tree = BuildStripeTree(&stripes, 4);
  EXPECT_EQ(CorrectGaps(stripes, Backplane, {}, &tree), 0);
}

}  // namespace
}  // namespace dorsum
