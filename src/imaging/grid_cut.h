// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

// The cheapest way to part the pixels of a grid in two, by maximum flow with two search trees (Boykov and
// Kolmogorov 2004, "An experimental comparison of min-cut/max-flow algorithms", with the marks of distance
// that their implementation has). Nodes that follow each other are cut on their own first, side by side, and
// then all together from there (Liu and Sun 2010, "Parallel graph-cuts by adaptive bottom-up merging").
// Neighbours lie in eight fixed directions. It is fastest when neighbours have near numbers.
class GridCut {
 public:
  static constexpr int kDirections = 8;

  explicit GridCut(std::size_t nodes);
  GridCut(const GridCut&) = delete;
  GridCut& operator=(const GridCut&) = delete;

  // What it costs to part `node` from the first side (> 0) or from the second (< 0); adds up. In all, costs
  // must stay within an int.
  void Pull(int node, int cost) { nodes_[static_cast<std::size_t>(node)].pull += cost; }
  // What it costs to part two neighbours, 0 to kMostCost, each way; once for each two. `direction` of `to`,
  // seen from `from`; directions 2 k and 2 k + 1 are opposite.
  void Join(int from, int to, int direction, int cost) {
    JoinOneWay(from, to, direction, cost);
    JoinOneWay(to, from, direction ^ 1, cost);
  }
  static constexpr int kMostCost = 16000;

  void Run(const Context& context = {});
  // After Run(). Where either is as cheap: the first side.
  bool IsFirst(int node) const {
    const Node& n = nodes_[static_cast<std::size_t>(node)];
    return n.parent == kNone || n.side == kFirst;
  }

 private:
  class Search;
  enum Side : std::uint8_t { kFirst, kSecond };
  // A node's parent in its tree: the direction of a neighbour, or one of these.
  enum Parent : std::uint8_t { kNone = kDirections, kTerminal, kOrphan };
  struct alignas(64) Node {
    std::array<std::int32_t, kDirections> to = {-1, -1, -1, -1, -1, -1, -1, -1};
    std::array<std::int16_t, kDirections> room{};  // capacity that is left
    std::int32_t pull = 0;                         // left of it, after Run() began
    std::int32_t stamp = 0, distance = 0;          // to the terminal, as it was known at that time
    std::uint8_t parent = kNone;
    Side side = kFirst;
    bool active = false;
  };

  void JoinOneWay(int from, int to, int direction, int cost) {
    Node& node = nodes_[static_cast<std::size_t>(from)];
    node.to[static_cast<std::size_t>(direction)] = to;
    node.room[static_cast<std::size_t>(direction)] = static_cast<std::int16_t>(cost);
  }

  cv::Mat memory_;  // of the nodes: as large as a picture, so that pictures' memory serves it
  std::span<Node> nodes_;
};

}  // namespace dorsum
