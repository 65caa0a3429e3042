// SPDX-License-Identifier: Apache-2.0
#include "imaging/grid_cut.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

namespace dorsum {
namespace {

const std::array<cv::Point, 4> kSteps = {{{1, 0}, {0, 1}, {1, 1}, {-1, 1}}};

struct Edge {
  int from, to, direction, cost;
};

// A grid with random costs; some pixels are no nodes, some edges are not there.
struct Problem {
  explicit Problem(unsigned seed, cv::Size size = {17, 13}) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    cv::Mat_<int> node(size, -1);
    for (int& n : node) {
      if (below(8) == 0) continue;
      n = static_cast<int>(pulls.size());
      pulls.push_back(below(3) == 0 ? below(2001) - 1000 : 0);
    }
    for (int v = 0; v < size.height; ++v) {
      for (int u = 0; u < size.width; ++u) {
        for (std::size_t i = 0; i < kSteps.size(); ++i) {
          const cv::Point other = cv::Point(u, v) + kSteps[i];
          if (!cv::Rect({0, 0}, size).contains(other) || node(v, u) < 0 || node(other) < 0) continue;
          if (below(6) > 0) edges.push_back({node(v, u), node(other), 2 * static_cast<int>(i), below(400)});
        }
      }
    }
  }
  template <class IsFirst>
  long Cost(IsFirst is_first) const {
    long cost = 0;
    for (std::size_t i = 0; i < pulls.size(); ++i) {
      if (is_first(static_cast<int>(i)) != (pulls[i] > 0)) cost += std::abs(pulls[i]);
    }
    for (const Edge& e : edges) {
      if (is_first(e.from) != is_first(e.to)) cost += e.cost;
    }
    return cost;
  }
  std::vector<int> pulls;
  std::vector<Edge> edges;
};

long Cheapest(const Problem& problem) {
  cv::detail::GCGraph<int> graph(static_cast<unsigned>(problem.pulls.size()),
                                 2 * static_cast<unsigned>(problem.edges.size()));
  for (const int pull : problem.pulls) {
    graph.addTermWeights(graph.addVtx(), std::max(pull, 0), std::max(-pull, 0));
  }
  for (const Edge& e : problem.edges) graph.addEdges(e.from, e.to, e.cost, e.cost);
  return graph.maxFlow();
}

long OurCost(const Problem& problem) {
  GridCut cut(problem.pulls.size());
  for (std::size_t i = 0; i < problem.pulls.size(); ++i) cut.Pull(static_cast<int>(i), problem.pulls[i]);
  for (const Edge& e : problem.edges) cut.Join(e.from, e.to, e.direction, e.cost);
  cut.Run();
  return problem.Cost([&](int node) { return cut.IsFirst(node); });
}

TEST(GridCutTest, CutsAsCheaplyAsAnotherProgramOnRandomGrids) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Problem problem(seed);
    ASSERT_EQ(OurCost(problem), Cheapest(problem)) << "seed " << seed;
  }
  const Problem large(7, {160, 120});
  EXPECT_EQ(OurCost(large), Cheapest(large));
}

TEST(GridCutTest, WhatNothingPullsGoesWithItsNeighbour) {
  GridCut cut(4);  // in a row, the weakest edge in the middle
  cut.Pull(0, 100);
  cut.Pull(3, -100);
  cut.Join(0, 1, 0, 50);
  cut.Join(1, 2, 0, 10);
  cut.Join(2, 3, 0, 50);
  cut.Run();
  EXPECT_TRUE(cut.IsFirst(0));
  EXPECT_TRUE(cut.IsFirst(1));
  EXPECT_FALSE(cut.IsFirst(2));
  EXPECT_FALSE(cut.IsFirst(3));
}

TEST(GridCutTest, NothingToPartIsNothing) {
  GridCut none(0);
  none.Run();
  GridCut alone(1);
  alone.Run();
  EXPECT_TRUE(alone.IsFirst(0));
}

}  // namespace
}  // namespace dorsum
