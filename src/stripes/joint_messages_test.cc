// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_messages.h"

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

// A ring of pieces with chords, every one with a few candidates, and costs drawn at random.
struct RandomGraph {
  std::vector<JointPiece> pieces;
  JointGraph graph;

  explicit RandomGraph(std::uint64_t seed, int count = 8) {
    Rng rng(seed);
    for (int i = 0; i < count; ++i) {
      JointPiece p;
      p.candidates = 2 + i % 2;
      p.samples.push_back({static_cast<float>(10 * i), 0.0F});
      pieces.push_back(p);
      std::vector<float> unary;
      unary.reserve(static_cast<std::size_t>(p.candidates));
      for (int k = 0; k < p.candidates; ++k) unary.push_back(static_cast<float>(rng.Uniform()));
      graph.unary.push_back(unary);
    }
    for (int i = 0; i < count; ++i) {
      for (const int step : {1, 3}) {
        JointEdge e;
        e.first = std::min(i, (i + step) % count);
        e.second = std::max(i, (i + step) % count);
        const int size = pieces[static_cast<std::size_t>(e.first)].candidates *
                         pieces[static_cast<std::size_t>(e.second)].candidates;
        for (int k = 0; k < size; ++k) e.heights.push_back(static_cast<float>(rng.Uniform()));
        e.orders.assign(e.heights.size(), 0.0F);
        graph.edges.push_back(e);
      }
    }
  }

  double Cost(const std::vector<int>& choice) const {
    double cost = 0.0;
    for (std::size_t i = 0; i < choice.size(); ++i) {
      cost += graph.unary[i][static_cast<std::size_t>(choice[i])];
    }
    for (const JointEdge& e : graph.edges) {
      cost += e.heights[static_cast<std::size_t>(choice[static_cast<std::size_t>(e.first)] *
                                                     pieces[static_cast<std::size_t>(e.second)].candidates +
                                                 choice[static_cast<std::size_t>(e.second)])];
    }
    return cost;
  }

  double Least() const {
    std::vector<int> choice(pieces.size(), 0);
    double least = Cost(choice);
    for (;;) {
      std::size_t i = 0;
      while (i < choice.size() && ++choice[i] == pieces[i].candidates) choice[i++] = 0;
      if (i == choice.size()) return least;
      least = std::min(least, Cost(choice));
    }
  }
};

TEST(JointMessages, ComeNearTheLeastCostOfGraphsWithLoops) {
  int exact = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomGraph random(seed);
    const double cost = random.Cost(PassMessages(random.pieces, random.graph, {})), least = random.Least();
    EXPECT_LT(cost, least + 1.0) << seed;
    if (cost < least + 1e-6) ++exact;
  }
  EXPECT_GE(exact, 10);
}

TEST(JointMessages, GivePiecesWithoutCandidatesNone) {
  RandomGraph random(1);
  random.pieces.emplace_back();
  random.graph.unary.emplace_back();
  const std::vector<int> chosen = PassMessages(random.pieces, random.graph, {});
  EXPECT_EQ(chosen.back(), -1);
  EXPECT_GE(chosen.front(), 0);
}

}  // namespace
}  // namespace dorsum
