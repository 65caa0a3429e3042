// SPDX-License-Identifier: Apache-2.0
#include "imaging/grid_cut.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr int kFar = std::numeric_limits<int>::max();
constexpr int kPartNodes = 4096;  // that are cut on their own; they fit a processor's cache

}  // namespace

GridCut::GridCut(std::size_t nodes) {
  static_assert(std::is_trivially_destructible_v<Node>);
  if (nodes == 0) return;
  std::size_t room = (nodes + 1) * sizeof(Node);
  memory_.create(1, static_cast<int>(room), CV_8UC1);
  void* begin = memory_.data;
  nodes_ = {static_cast<Node*>(std::align(alignof(Node), nodes * sizeof(Node), begin, room)), nodes};
  std::uninitialized_default_construct(nodes_.begin(), nodes_.end());
}

// The search among the nodes first to end - 1, from whatever trees they are in.
class GridCut::Search {
 public:
  Search(std::span<Node> nodes, int first, int end, int time)
      : nodes_(nodes.data()),
        first_(first),
        count_(static_cast<unsigned>(end - first)),
        time_(time),
        active_(count_) {}

  void Activate(int node) {
    Node& n = nodes_[node];
    if (n.active) return;
    n.active = true;
    active_[oldest_ + waiting_ < count_ ? oldest_ + waiting_ : oldest_ + waiting_ - count_] = node;
    ++waiting_;
  }
  void Run();
  int time() const { return time_; }

 private:
  struct Meeting {
    int first = -1, direction = 0, second = -1;
  };

  bool IsWithin(int node) const { return static_cast<unsigned>(node - first_) < count_; }
  static std::int16_t& Room(Node& node, int direction) {
    return node.room[static_cast<std::size_t>(direction)];
  }
  static int To(const Node& node, int direction) { return node.to[static_cast<std::size_t>(direction)]; }
  // Along the flow between a node and its neighbour, the node being the farther one from its terminal. Flow
  // runs from the first terminal to the second: in the first tree towards the child, in the second towards
  // the parent.
  static std::int16_t& RoomToward(Node& node, Node& other, int direction) {
    return node.side == kFirst ? Room(other, direction ^ 1) : Room(node, direction);
  }
  bool Grow(int node, Meeting* meeting);
  void Augment(const Meeting& meeting);
  int Least(int node, int least);
  void Push(int node, int flow);
  void MakeOrphan(int node);
  void Adopt();
  void FindParent(int orphan);
  int DistanceOf(int node);

  Node* nodes_;
  int first_;
  unsigned count_;
  int time_;
  std::vector<int> active_;  // a ring
  std::size_t oldest_ = 0, waiting_ = 0;
  std::vector<int> orphans_;
};

void GridCut::Search::Run() {
  while (waiting_ > 0) {
    const int node = active_[oldest_];
    Meeting meeting;
    if (nodes_[node].parent != kNone && Grow(node, &meeting)) {
      ++time_;
      Augment(meeting);
      Adopt();
      continue;  // the node may meet further ones
    }
    oldest_ = oldest_ + 1 == count_ ? 0 : oldest_ + 1;
    --waiting_;
    nodes_[node].active = false;
  }
}

// Takes free neighbours into the node's tree, until one of the other tree is met.
bool GridCut::Search::Grow(int node, Meeting* meeting) {
  const Node& n = nodes_[node];
  const bool is_first = n.side == kFirst;
  unsigned wanted = 0;  // a bit for each direction; found first, without branches that cannot be foreseen
  for (int direction = 0; direction < kDirections; ++direction) {
    const int to = To(n, direction), other = IsWithin(to) ? to : node;
    const Node& o = nodes_[other];
    const int room = is_first ? n.room[static_cast<std::size_t>(direction)]
                              : o.room[static_cast<std::size_t>(direction ^ 1)];
    const unsigned is_new =
        static_cast<unsigned>(o.parent == kNone) | static_cast<unsigned>(o.side != n.side) |
        (static_cast<unsigned>(o.stamp <= n.stamp) & static_cast<unsigned>(o.distance > n.distance));
    wanted |= (is_new & static_cast<unsigned>(room != 0)) << static_cast<unsigned>(direction);
  }
  for (; wanted != 0; wanted &= wanted - 1) {
    const int direction = std::countr_zero(wanted), other = To(n, direction);
    Node& o = nodes_[other];
    const bool is_free = o.parent == kNone;
    if (!is_free && o.side != n.side) {
      *meeting = is_first ? Meeting{node, direction, other} : Meeting{other, direction ^ 1, node};
      return true;
    }
    o.side = n.side;
    o.parent = static_cast<std::uint8_t>(direction ^ 1);
    o.stamp = n.stamp;
    o.distance = n.distance + 1;
    if (is_free) Activate(other);
  }
  return false;
}

// The least that may flow between the node and its terminal, and is not more than `least`.
int GridCut::Search::Least(int node, int least) {
  while (nodes_[node].parent != kTerminal) {
    Node& n = nodes_[node];
    node = To(n, n.parent);
    least = std::min<int>(least, RoomToward(n, nodes_[node], n.parent));
  }
  return std::min(least, std::abs(nodes_[node].pull));
}

void GridCut::Search::Push(int node, int flow) {
  while (nodes_[node].parent != kTerminal) {
    Node& n = nodes_[node];
    const int direction = n.parent, parent = To(n, direction);
    std::int16_t& down = Room(nodes_[parent], direction ^ 1);
    std::int16_t& up = Room(n, direction);
    std::int16_t& room = n.side == kFirst ? down : up;
    std::int16_t& back = n.side == kFirst ? up : down;
    room = static_cast<std::int16_t>(room - flow);
    back = static_cast<std::int16_t>(back + flow);
    if (room == 0) MakeOrphan(node);
    node = parent;
  }
  int& pull = nodes_[node].pull;
  pull -= pull > 0 ? flow : -flow;
  if (pull == 0) MakeOrphan(node);
}

void GridCut::Search::Augment(const Meeting& meeting) {
  std::int16_t& room = Room(nodes_[meeting.first], meeting.direction);
  std::int16_t& back = Room(nodes_[meeting.second], meeting.direction ^ 1);
  const int flow = Least(meeting.second, Least(meeting.first, room));
  room = static_cast<std::int16_t>(room - flow);
  back = static_cast<std::int16_t>(back + flow);
  Push(meeting.first, flow);
  Push(meeting.second, flow);
}

void GridCut::Search::MakeOrphan(int node) {
  nodes_[node].parent = kOrphan;
  orphans_.push_back(node);
}

// Those nearest to the terminal first: their children may then stay where they are.
void GridCut::Search::Adopt() {
  while (!orphans_.empty()) {
    const int orphan = orphans_.back();
    orphans_.pop_back();
    FindParent(orphan);
  }
}

// Steps from the node to its terminal; kFar if an orphan lies on the way. What is found is marked.
int GridCut::Search::DistanceOf(int node) {
  int steps = 0;
  for (int at = node;; at = To(nodes_[at], nodes_[at].parent)) {
    Node& n = nodes_[at];
    if (n.stamp == time_) {
      steps += n.distance;
      break;
    }
    ++steps;
    if (n.parent == kOrphan) return kFar;
    if (n.parent == kTerminal) {
      n.stamp = time_;
      n.distance = 1;
      break;
    }
  }
  int left = steps;
  for (int at = node; nodes_[at].stamp != time_; at = To(nodes_[at], nodes_[at].parent)) {
    nodes_[at].stamp = time_;
    nodes_[at].distance = left--;
  }
  return steps;
}

void GridCut::Search::FindParent(int orphan) {
  Node& n = nodes_[orphan];
  int nearest = kFar;
  std::uint8_t parent = kNone;
  unsigned of_own_tree = 0;  // a bit for each direction
  for (int direction = 0; direction < kDirections; ++direction) {
    const int other = To(n, direction);
    if (!IsWithin(other)) continue;
    Node& o = nodes_[other];
    if (o.side != n.side || o.parent == kNone) continue;
    of_own_tree |= 1U << static_cast<unsigned>(direction);
    if (RoomToward(n, o, direction) == 0) continue;
    const int distance = DistanceOf(other);
    if (distance >= nearest) continue;
    nearest = distance;
    parent = static_cast<std::uint8_t>(direction);
    if (distance < n.distance) break;
  }
  n.parent = parent;
  if (parent != kNone) {
    n.stamp = time_;
    n.distance = nearest + 1;
    return;
  }
  for (int direction = 0; direction < kDirections; ++direction) {
    if ((of_own_tree >> static_cast<unsigned>(direction) & 1U) == 0) continue;
    const int other = To(n, direction);
    if (RoomToward(n, nodes_[other], direction) > 0) Activate(other);
    if (nodes_[other].parent == (direction ^ 1)) MakeOrphan(other);
  }
}

void GridCut::Run(const Context& context) {
  const int count = static_cast<int>(nodes_.size()), parts = (count + kPartNodes - 1) / kPartNodes;
  std::vector<int> times(static_cast<std::size_t>(parts), 0);
  ParallelFor(context, 0, parts, [&](std::int64_t part) {
    const int first = static_cast<int>(part) * kPartNodes, end = std::min(count, first + kPartNodes);
    Search search(nodes_, first, end, 0);
    for (int node = first; node < end; ++node) {
      Node& n = nodes_[static_cast<std::size_t>(node)];
      if (n.pull == 0) continue;
      n.side = n.pull > 0 ? kFirst : kSecond;
      n.parent = kTerminal;
      n.distance = 1;
      search.Activate(node);
    }
    search.Run();
    times[static_cast<std::size_t>(part)] = search.time();
  });
  if (parts <= 1) return;
  // What has neighbours in another part goes on growing.
  Search search(nodes_, 0, count, *std::max_element(times.begin(), times.end()));
  for (int node = 0; node < count; ++node) {
    const Node& n = nodes_[static_cast<std::size_t>(node)];
    if (n.parent == kNone) continue;
    const bool at_seam = std::any_of(n.to.begin(), n.to.end(), [&](int other) {
      return other >= 0 && other / kPartNodes != node / kPartNodes;
    });
    if (at_seam) search.Activate(node);
  }
  search.Run();
}

}  // namespace dorsum
