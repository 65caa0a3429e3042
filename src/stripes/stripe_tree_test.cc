// SPDX-License-Identifier: Apache-2.0
#include "stripes/stripe_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stripes/stripe_layout_test.h"

namespace dorsum {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// As in Figure 3.6: a long stripe, two short ones above each other to its right, and a long one again.
LaserStripes Figure() {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 100, 10.0);   // 0
  AddStripe(&stripes, 0, 40, 30.0);    // 1
  AddStripe(&stripes, 60, 100, 32.0);  // 2
  AddStripe(&stripes, 0, 100, 50.0);   // 3
  return stripes;
}

TEST(StripeTree, LevelsParentsAndChildrenOfTheDocumentsFigure) {
  LaserStripes stripes = Figure();
  const StripeTree tree = BuildStripeTree(&stripes, 4);
  ASSERT_EQ(tree.nodes.size(), 4U);
  EXPECT_THAT(tree.roots, ElementsAre(0));
  EXPECT_THAT(tree.nodes[0].children, UnorderedElementsAre(1, 2, 3));
  EXPECT_THAT(tree.nodes[1].parents, ElementsAre(0));
  EXPECT_THAT(tree.nodes[2].parents, ElementsAre(0));
  EXPECT_THAT(tree.nodes[3].parents, UnorderedElementsAre(0, 1, 2));
  EXPECT_EQ(tree.nodes[0].level, 0);
  EXPECT_EQ(tree.nodes[1].level, 1);
  EXPECT_EQ(tree.nodes[2].level, 1);
  EXPECT_EQ(tree.nodes[3].level, 2) << "the parent that shares most rows decides";
}

TEST(StripeTree, LeftAndRightAreTheNextStripesOfTheRow) {
  LaserStripes stripes = Figure();
  BuildStripeTree(&stripes, 4);
  const auto& points = stripes.points;
  EXPECT_EQ(points[20].left, kNoPoint);
  EXPECT_EQ(points[20].right, 120);  // stripe 1 in row 20
  EXPECT_EQ(points[120].left, 20);
  EXPECT_EQ(points[120].right, 180 + 20);  // stripe 3
  EXPECT_EQ(points[180 + 20].right, kNoPoint);
  EXPECT_EQ(points[50].right, 180 + 50);  // nothing between in row 50
  EXPECT_EQ(points[180 + 50].left, 50);
}

TEST(StripeTree, TooFewSharedRowsMakeNoParent) {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 23, 10.0);
  AddStripe(&stripes, 20, 60, 30.0);
  EXPECT_THAT(BuildStripeTree(&stripes, 4).roots, ElementsAre(0, 1));
  EXPECT_THAT(BuildStripeTree(&stripes, 3).roots, ElementsAre(0));
}

TEST(StripeTree, ALongSlantedStripeThatBeginsLeftOfItsParentIsStillItsChild) {
  // Leaning stripes: the last one runs over all rows, so that its foot lies left of its short ancestors.
  const auto leaning = [](double at) { return [at](int row) { return at + 0.5 * row; }; };
  LaserStripes stripes;
  AddStripe(&stripes, 0, 200, leaning(70.0));    // 0: grandchild
  AddStripe(&stripes, 100, 200, leaning(50.0));  // 1: child
  AddStripe(&stripes, 100, 200, leaning(30.0));  // 2: root
  ASSERT_LT(stripes.segments[0].min_u, stripes.segments[2].min_u);
  const StripeTree tree = BuildStripeTree(&stripes, 4);
  EXPECT_EQ(tree.nodes[2].level, 0);
  EXPECT_EQ(tree.nodes[1].level, 1);
  EXPECT_EQ(tree.nodes[0].level, 2);
}

TEST(StripeTree, CrossingPiecesDoNotBecomeEachOthersParents) {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 100, [](int row) { return 10.0 + row; });
  AddStripe(&stripes, 0, 100, [](int row) { return 70.5 - row; });
  const StripeTree tree = BuildStripeTree(&stripes, 4);
  EXPECT_THAT(tree.roots, ElementsAre(1)) << "right of the other in most rows is stripe 0";
  EXPECT_EQ(tree.nodes[0].level, 1);
  EXPECT_EQ(tree.nodes[1].level, 0);
}

TEST(StripeTree, PiecesInACircleDoNotHang) {
  // 0 left of 1 left of 2 left of 0, each in rows of their own.
  LaserStripes stripes;
  AddStripe(&stripes, 0, 30, [](int row) { return row < 15 ? 10.0 : 50.0; });
  AddStripe(&stripes, 0, 40, [](int row) { return row < 15 ? 20.0 : 10.0; });
  AddStripe(&stripes, 15, 40, [](int row) { return row < 30 ? 40.0 : 20.0; });
  const StripeTree tree = BuildStripeTree(&stripes, 4);
  for (const StripeNode& node : tree.nodes) EXPECT_LE(node.level, 3);
}

TEST(StripeTree, NoStripesGiveAnEmptyTree) {
  LaserStripes stripes;
  const StripeTree tree = BuildStripeTree(&stripes, 4);
  EXPECT_THAT(tree.nodes, IsEmpty());
  EXPECT_THAT(tree.roots, IsEmpty());
}

}  // namespace
}  // namespace dorsum
