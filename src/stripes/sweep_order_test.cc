// SPDX-License-Identifier: Apache-2.0
#include "stripes/sweep_order.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

JointPiece At(float column) {
  JointPiece piece;
  piece.samples.push_back({column, 0.0F});
  return piece;
}

JointEdge Between(int first, int second) {
  JointEdge edge;
  edge.first = first;
  edge.second = second;
  return edge;
}

TEST(SweepOrder, GoesInwardsFromBothSidesAndEndsWithWhatJoinsThem) {
  const std::vector<JointPiece> pieces = {At(50), At(10), At(20), At(40), At(30), At(60)};
  JointGraph graph;
  graph.edges = {Between(1, 2), Between(2, 4), Between(4, 3), Between(3, 0), Between(0, 5)};
  const SweepOrder order = OrderSweeps(pieces, graph);
  EXPECT_EQ(order.pieces, (std::vector<std::size_t>{1, 2, 5, 0, 4, 3}));
  EXPECT_EQ(order.left_end, 2U);
  EXPECT_EQ(order.right_end, 4U);
}

TEST(SweepOrder, TakesPiecesWithoutSamplesOrNeighbours) {
  const SweepOrder none = OrderSweeps({}, {});
  EXPECT_TRUE(none.pieces.empty());
  const SweepOrder order = OrderSweeps({At(5), {}, At(1)}, {});
  EXPECT_EQ(order.pieces, (std::vector<std::size_t>{1, 0, 2}));
  EXPECT_EQ(order.right_end, 3U);
}

}  // namespace
}  // namespace dorsum
