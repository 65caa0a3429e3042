// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dorsum {

// The cheapest way to part the pixels of a grid in two, by maximum flow with two search trees (Boykov and
// Kolmogorov 2004, "An experimental comparison of min-cut/max-flow algorithms", with the marks of distance
// that their implementation has). Neighbours lie in eight fixed directions, so that an edge needs no more
// memory than its capacity.
class GridCut {
 public:
  static constexpr int kDirections = 8;

  explicit GridCut(std::size_t nodes);

  // What it costs to part `node` from the first side (> 0) or from the second (< 0); adds up. In all, costs
  // must stay within an int.
  void Pull(int node, int cost) { pull_[static_cast<std::size_t>(node)] += cost; }
  // What it costs to part two neighbours, >= 0, each way. `direction` of `to`, seen from `from`; directions
  // 2 k and 2 k + 1 are opposite.
  void Join(int from, int to, int direction, int cost);

  void Run();
  // After Run(). Where either is as cheap: the side that the search came to the node from last.
  bool IsFirst(int node) const { return side_[static_cast<std::size_t>(node)] == kFirst; }

 private:
  enum Side : std::uint8_t { kFirst, kSecond };
  // A node's parent in its tree: the direction of a neighbour, or one of these.
  enum Parent : std::uint8_t { kNone = kDirections, kTerminal, kOrphan };
  struct Meeting {
    int first = -1, direction = 0, second = -1;
  };

  static std::size_t Edge(int node, int direction) {
    return static_cast<std::size_t>(node) * kDirections + static_cast<std::size_t>(direction);
  }
  std::uint8_t& ParentOf(int node) { return parent_[static_cast<std::size_t>(node)]; }
  Side SideOf(int node) const { return static_cast<Side>(side_[static_cast<std::size_t>(node)]); }
  int ParentNode(int node) { return to_[Edge(node, ParentOf(node))]; }
  // Along the flow between a node and its neighbour, the node being the farther one from its terminal.
  int& RoomToward(int node, int direction);
  void Activate(int node);
  bool Grow(int node, Meeting* meeting);
  void Augment(const Meeting& meeting);
  int Least(int node, int least);
  void Push(int node, int flow);
  void MakeOrphan(int node);
  void Adopt();
  void FindParent(int orphan);
  int DistanceOf(int node);

  std::vector<int> pull_;       // left of it, after Run() began
  std::vector<int> to_, room_;  // of each edge: the neighbour, or -1, and the capacity that is left
  std::vector<std::uint8_t> parent_, side_;
  std::vector<int> stamp_, distance_;  // to the terminal, as it was known at that time
  std::vector<int> next_;              // active nodes, a list; -1: not active; the last is its own next
  int first_active_ = -1, last_active_ = -1, time_ = 0;
  std::vector<int> orphans_;
};

}  // namespace dorsum
