// SPDX-License-Identifier: Apache-2.0
#include "imaging/grid_cut.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace dorsum {
namespace {

constexpr int kFar = std::numeric_limits<int>::max();

}  // namespace

GridCut::GridCut(std::size_t nodes)
    : pull_(nodes, 0),
      to_(nodes * kDirections, -1),
      room_(nodes * kDirections, 0),
      parent_(nodes, kNone),
      side_(nodes, kFirst),
      stamp_(nodes, 0),
      distance_(nodes, 0),
      next_(nodes, -1) {}

void GridCut::Join(int from, int to, int direction, int cost) {
  to_[Edge(from, direction)] = to;
  to_[Edge(to, direction ^ 1)] = from;
  room_[Edge(from, direction)] += cost;
  room_[Edge(to, direction ^ 1)] += cost;
}

// Flow runs from the first terminal to the second: in the first tree towards the child, in the second
// towards the parent.
int& GridCut::RoomToward(int node, int direction) {
  const std::size_t edge = Edge(node, direction);
  return SideOf(node) == kFirst ? room_[Edge(to_[edge], direction ^ 1)] : room_[edge];
}

void GridCut::Activate(int node) {
  int& next = next_[static_cast<std::size_t>(node)];
  if (next >= 0) return;
  next = node;
  if (last_active_ < 0) {
    first_active_ = node;
  } else {
    next_[static_cast<std::size_t>(last_active_)] = node;
  }
  last_active_ = node;
}

void GridCut::Run() {
  for (int node = 0; node < static_cast<int>(pull_.size()); ++node) {
    const auto i = static_cast<std::size_t>(node);
    if (pull_[i] == 0) continue;
    side_[i] = pull_[i] > 0 ? kFirst : kSecond;
    parent_[i] = kTerminal;
    distance_[i] = 1;
    Activate(node);
  }
  while (first_active_ >= 0) {
    const int node = first_active_;
    Meeting meeting;
    if (ParentOf(node) != kNone && Grow(node, &meeting)) {
      ++time_;
      Augment(meeting);
      Adopt();
      continue;  // the node may meet further ones
    }
    int& next = next_[static_cast<std::size_t>(node)];
    first_active_ = next == node ? -1 : next;
    if (first_active_ < 0) last_active_ = -1;
    next = -1;
  }
}

// Takes free neighbours into the node's tree, until one of the other tree is met.
bool GridCut::Grow(int node, Meeting* meeting) {
  const auto i = static_cast<std::size_t>(node);
  const Side side = SideOf(node);
  for (int direction = 0; direction < kDirections; ++direction) {
    const std::size_t edge = Edge(node, direction);
    const int other = to_[edge];
    if (other < 0) continue;
    const int room = side == kFirst ? room_[edge] : room_[Edge(other, direction ^ 1)];
    if (room == 0) continue;
    const auto j = static_cast<std::size_t>(other);
    const bool is_free = parent_[j] == kNone;
    if (!is_free && side_[j] != side) {
      *meeting = side == kFirst ? Meeting{node, direction, other} : Meeting{other, direction ^ 1, node};
      return true;
    }
    const bool is_shorter = stamp_[j] <= stamp_[i] && distance_[j] > distance_[i];
    if (!is_free && !is_shorter) continue;
    side_[j] = side;
    parent_[j] = static_cast<std::uint8_t>(direction ^ 1);
    stamp_[j] = stamp_[i];
    distance_[j] = distance_[i] + 1;
    if (is_free) Activate(other);
  }
  return false;
}

// The least that may flow between the node and its terminal, and is not more than `least`.
int GridCut::Least(int node, int least) {
  for (; ParentOf(node) != kTerminal; node = ParentNode(node)) {
    least = std::min(least, RoomToward(node, ParentOf(node)));
  }
  return std::min(least, std::abs(pull_[static_cast<std::size_t>(node)]));
}

void GridCut::Push(int node, int flow) {
  while (ParentOf(node) != kTerminal) {
    const int direction = ParentOf(node), parent = ParentNode(node);
    int& room = RoomToward(node, direction);
    room -= flow;
    // Back along the same edge.
    room_[SideOf(node) == kFirst ? Edge(node, direction) : Edge(parent, direction ^ 1)] += flow;
    if (room == 0) MakeOrphan(node);
    node = parent;
  }
  int& pull = pull_[static_cast<std::size_t>(node)];
  pull -= pull > 0 ? flow : -flow;
  if (pull == 0) MakeOrphan(node);
}

void GridCut::Augment(const Meeting& meeting) {
  int& room = room_[Edge(meeting.first, meeting.direction)];
  const int flow = Least(meeting.second, Least(meeting.first, room));
  room -= flow;
  room_[Edge(meeting.second, meeting.direction ^ 1)] += flow;
  Push(meeting.first, flow);
  Push(meeting.second, flow);
}

void GridCut::MakeOrphan(int node) {
  ParentOf(node) = kOrphan;
  orphans_.push_back(node);
}

// Those nearest to the terminal first: their children may then stay where they are.
void GridCut::Adopt() {
  while (!orphans_.empty()) {
    const int orphan = orphans_.back();
    orphans_.pop_back();
    FindParent(orphan);
  }
}

// Steps from the node to its terminal; kFar if an orphan lies on the way. What is found is marked.
int GridCut::DistanceOf(int node) {
  int steps = 0;
  int at = node;
  for (;; at = ParentNode(at)) {
    const auto i = static_cast<std::size_t>(at);
    if (stamp_[i] == time_) {
      steps += distance_[i];
      break;
    }
    ++steps;
    if (parent_[i] == kOrphan) return kFar;
    if (parent_[i] == kTerminal) {
      stamp_[i] = time_;
      distance_[i] = 1;
      break;
    }
  }
  int left = steps;
  for (at = node; stamp_[static_cast<std::size_t>(at)] != time_; at = ParentNode(at)) {
    stamp_[static_cast<std::size_t>(at)] = time_;
    distance_[static_cast<std::size_t>(at)] = left--;
  }
  return steps;
}

void GridCut::FindParent(int orphan) {
  const auto i = static_cast<std::size_t>(orphan);
  int nearest = kFar;
  std::uint8_t parent = kNone;
  unsigned of_own_tree = 0;  // a bit for each direction
  for (int direction = 0; direction < kDirections; ++direction) {
    const int other = to_[Edge(orphan, direction)];
    if (other < 0) continue;
    const auto j = static_cast<std::size_t>(other);
    if (side_[j] != side_[i] || parent_[j] == kNone) continue;
    of_own_tree |= 1U << static_cast<unsigned>(direction);
    if (RoomToward(orphan, direction) == 0) continue;
    const int distance = DistanceOf(other);
    if (distance >= nearest) continue;
    nearest = distance;
    parent = static_cast<std::uint8_t>(direction);
  }
  parent_[i] = parent;
  if (parent != kNone) {
    stamp_[i] = time_;
    distance_[i] = nearest + 1;
    return;
  }
  for (int direction = 0; direction < kDirections; ++direction) {
    if ((of_own_tree >> static_cast<unsigned>(direction) & 1U) == 0) continue;
    const int other = to_[Edge(orphan, direction)];
    if (RoomToward(orphan, direction) > 0) Activate(other);
    if (ParentOf(other) == (direction ^ 1)) MakeOrphan(other);
  }
}

}  // namespace dorsum
