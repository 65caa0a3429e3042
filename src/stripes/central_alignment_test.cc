// SPDX-License-Identifier: Apache-2.0
#include "stripes/central_alignment.h"

#include <gtest/gtest.h>

#include "stripes/stripe_layout_test.h"

namespace dorsum {
namespace {

// Stripe 3 of 7 (u = 80) is order 0 at every height.
std::pair<double, double> AllPossible(float u, float /*v*/) {
  return {(u - 80.0) / 20.0 - 3.0, (u - 80.0) / 20.0 + 3.0};
}

double CentralTwiceAsBright(int order) { return order == 0 ? 2.0 : 1.0; }

LaserStripes SevenStripes(const std::vector<double>& peaks, int rows = 50) {
  LaserStripes stripes;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    AddStripe(&stripes, 0, rows, 20.0 + 20.0 * static_cast<double>(i), peaks[i]);
  }
  return stripes;
}

std::vector<int> Align(LaserStripes* stripes, const OrderRange& range) {
  const StripeTree tree = BuildStripeTree(stripes, 4);
  AlignToCentralStripe(tree, range, CentralTwiceAsBright, {}, stripes);
  std::vector<int> orders;
  orders.reserve(stripes->segments.size());
  for (const StripeSegment& s : stripes->segments) orders.push_back(s.order.value_or(999));
  return orders;
}

TEST(CentralAlignment, TheBrightestStripeBecomesOrderZero) {
  LaserStripes stripes = SevenStripes({90, 100, 100, 200, 100, 100, 90});
  EXPECT_EQ(Align(&stripes, AllPossible), (std::vector<int>{-3, -2, -1, 0, 1, 2, 3}));
}

TEST(CentralAlignment, TheBrightestStripeNeedNotBeInTheMiddle) {
  LaserStripes stripes = SevenStripes({90, 220, 100, 100, 100, 100, 90});
  EXPECT_EQ(Align(&stripes, AllPossible), (std::vector<int>{-1, 0, 1, 2, 3, 4, 5}));
}

TEST(CentralAlignment, ADimmedCentralStripeDoesNotLiftTheObject) {
  // The lowest heights make the third stripe the central one, although it is as dim as the others: a slope
  // can dim it. Numberings that keep order 0 off the object would lift all heights by whole spacings.
  LaserStripes stripes = SevenStripes({100, 101, 100, 102, 100, 101, 100});
  const OrderRange rising = [](float u, float) {
    const double at_bottom = -2.5 + (u - 20.0) / 20.0;
    return std::pair(at_bottom, at_bottom + 8.0);
  };
  EXPECT_EQ(Align(&stripes, rising), (std::vector<int>{-2, -1, 0, 1, 2, 3, 4}));
}

TEST(CentralAlignment, ABrightRemnantIsNotTheCentralStripe) {
  LaserStripes stripes = SevenStripes({90, 100, 100, 180, 100, 100});
  AddStripe(&stripes, 0, 8, 140.0, 255.0);
  EXPECT_EQ(Align(&stripes, AllPossible), (std::vector<int>{-3, -2, -1, 0, 1, 2, 3}));
}

TEST(CentralAlignment, ABrightStripeOutsideTheWorkingVolumeIsNotTheCentralOne) {
  LaserStripes stripes = SevenStripes({250, 100, 100, 180, 100, 100, 90});
  // At u = 20 the volume allows orders -3.3 to -2.3 only.
  const OrderRange narrow = [](float u, float) {
    return std::pair((u - 80.0) / 20.0 - 0.3, (u - 80.0) / 20.0 + 0.7);
  };
  EXPECT_EQ(Align(&stripes, narrow), (std::vector<int>{-3, -2, -1, 0, 1, 2, 3}));
}

TEST(CentralAlignment, WithNoCentralStripeOnTheObjectTheLowestHeightsAreTaken) {
  // Even brightness. On the backplane stripe i has order 5.4 + i; higher surfaces would make it more.
  LaserStripes stripes = SevenStripes({100, 101, 100, 102, 100, 101, 100});
  const OrderRange rising = [](float u, float) {
    const double at_bottom = 5.4 + (u - 20.0) / 20.0;
    return std::pair(at_bottom, at_bottom + 3.0);
  };
  EXPECT_EQ(Align(&stripes, rising), (std::vector<int>{6, 7, 8, 9, 10, 11, 12}));
  const OrderRange falling = [](float u, float) {
    const double at_bottom = 5.4 + (u - 20.0) / 20.0;
    return std::pair(at_bottom, at_bottom - 3.0);
  };
  EXPECT_EQ(Align(&stripes, falling), (std::vector<int>{5, 6, 7, 8, 9, 10, 11}));
}

TEST(CentralAlignment, ASurfaceThatTouchesTheBackplaneIsNotLiftedByAWholeOrder) {
  LaserStripes stripes = SevenStripes({100, 101, 100, 102, 100, 101, 100});
  const OrderRange rising = [](float u, float) {
    const double at_bottom = 5.05 + (u - 20.0) / 20.0;
    return std::pair(at_bottom, at_bottom + 3.0);
  };
  EXPECT_EQ(Align(&stripes, rising).front(), 5);
}

TEST(CentralAlignment, PiecesOfOneLevelShareTheOrder) {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 100, 20.0, 100.0);
  AddStripe(&stripes, 0, 40, 40.0, 200.0);
  AddStripe(&stripes, 60, 100, 41.0, 200.0);
  AddStripe(&stripes, 0, 100, 60.0, 100.0);
  EXPECT_EQ(Align(&stripes, AllPossible), (std::vector<int>{-1, 0, 0, 1}));
}

TEST(CentralAlignment, NoStripesAreNoTrouble) {
  LaserStripes stripes;
  EXPECT_TRUE(Align(&stripes, AllPossible).empty());
}

}  // namespace
}  // namespace dorsum
