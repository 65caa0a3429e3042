// SPDX-License-Identifier: Apache-2.0
#include "stripes/gap_correction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ranges>

#include "base/median.h"

namespace dorsum {
namespace {

struct Predecessor {
  std::int32_t segment = kNoPoint;
  double spacings = 0.0;  // distance in usual spacings
};

// The neighbour to the left in most rows, and the usual distance to it.
Predecessor StrongestParent(const LaserStripes& stripes, const std::vector<double>& orders,
                            std::int32_t segment, const std::vector<std::int32_t>& parents) {
  std::map<std::int32_t, std::vector<double>> distances;
  const StripeSegment& s = stripes.segments[static_cast<std::size_t>(segment)];
  for (std::int32_t i = s.first; i < s.first + s.count; ++i) {
    const std::int32_t left = stripes.points[static_cast<std::size_t>(i)].left;
    if (left == kNoPoint) continue;
    distances[stripes.points[static_cast<std::size_t>(left)].segment].push_back(
        orders[static_cast<std::size_t>(i)] - orders[static_cast<std::size_t>(left)]);
  }
  Predecessor best;
  std::size_t most = 0;
  for (auto& [parent, values] : distances) {
    if (values.size() <= most || std::find(parents.begin(), parents.end(), parent) == parents.end()) continue;
    most = values.size();
    best = {parent, Median(values)};
  }
  return best;
}

// How far two stripes are from each other, and how much further right the second stands, in spacings. Both
// are taken between the ends that face each other, since a stripe over a curved hand can wander by more than
// half a spacing; stripes that share rows are compared in their middles.
struct Step {
  double distance_px = 0.0;
  double spacings = 0.0;
};

Step StepBetween(const LaserStripes& stripes, const std::vector<double>& orders, const StripeSegment& o,
                 const StripeSegment& s) {
  std::int32_t from = o.first + o.count / 2, to = s.first + s.count / 2;
  if (s.min_v > o.max_v) {
    from = o.first + o.count - 1;
    to = s.first;
  } else if (s.max_v < o.min_v) {
    from = o.first;
    to = s.first + s.count - 1;
  }
  const StripePoint& p = stripes.points[static_cast<std::size_t>(from)];
  const StripePoint& q = stripes.points[static_cast<std::size_t>(to)];
  return {std::hypot(q.u - p.u, q.v - p.v),
          orders[static_cast<std::size_t>(to)] - orders[static_cast<std::size_t>(from)]};
}

// A tree of its own: a stripe without a predecessor, and all that follow it. Levels count from its root.
struct Group {
  std::vector<std::int32_t> members;  // predecessors before those that follow them
  std::int32_t points = 0;
};

// Follows the predecessors to the roots; `levels` and `corrections` are what the distances along the way say.
std::vector<Group> GroupByRoot(const LaserStripes& stripes, const std::vector<Predecessor>& parents,
                               const GapCorrectionOptions& options, std::vector<int>* levels,
                               int* corrections) {
  const std::size_t n = parents.size();
  std::vector<std::int32_t> group_of(n, kNoPoint);
  std::vector<Group> groups;
  for (std::size_t start = 0; start < n; ++start) {
    std::vector<std::int32_t> line;  // from here up to the first whose group is known, or to the root
    auto i = static_cast<std::int32_t>(start);
    while (i != kNoPoint && group_of[static_cast<std::size_t>(i)] == kNoPoint &&
           std::find(line.begin(), line.end(), i) == line.end()) {
      line.push_back(i);
      i = parents[static_cast<std::size_t>(i)].segment;
    }
    for (const std::int32_t k : line | std::views::reverse) {
      const auto index = static_cast<std::size_t>(k);
      const Predecessor& p = parents[index];
      const bool rooted = p.segment != kNoPoint && group_of[static_cast<std::size_t>(p.segment)] != kNoPoint;
      if (!rooted) {
        group_of[index] = static_cast<std::int32_t>(groups.size());
        groups.emplace_back();
      } else {
        const int steps = p.spacings <= options.max_spacings ? 1 : static_cast<int>(std::lround(p.spacings));
        if (steps != 1) ++*corrections;
        group_of[index] = group_of[static_cast<std::size_t>(p.segment)];
        (*levels)[index] = (*levels)[static_cast<std::size_t>(p.segment)] + steps;
      }
      Group& group = groups[static_cast<std::size_t>(group_of[index])];
      group.members.push_back(k);
      group.points += stripes.segments[index].count;
    }
  }
  return groups;
}

// By how many levels a group must move to fit those already placed: where one of its stripes comes nearest to
// one of theirs.
int LevelOffset(const LaserStripes& stripes, const std::vector<double>& orders, const Group& group,
                const std::vector<std::int32_t>& placed, const std::vector<int>& levels) {
  double least = std::numeric_limits<double>::max();
  int offset = 0;
  for (const std::int32_t mine : group.members) {
    const StripeSegment& s = stripes.segments[static_cast<std::size_t>(mine)];
    for (const std::int32_t other : placed) {
      const StripeSegment& o = stripes.segments[static_cast<std::size_t>(other)];
      const Step step = StepBetween(stripes, orders, o, s);
      if (step.distance_px >= least) continue;
      least = step.distance_px;
      offset = levels[static_cast<std::size_t>(other)] + static_cast<int>(std::lround(step.spacings)) -
               levels[static_cast<std::size_t>(mine)];
    }
  }
  return offset;
}

}  // namespace

int CorrectGaps(const LaserStripes& stripes, const BackplaneOrder& backplane_order,
                const GapCorrectionOptions& options, StripeTree* tree) {
  const std::size_t n = stripes.segments.size();
  std::vector<double> orders;
  orders.reserve(stripes.points.size());
  for (const StripePoint& p : stripes.points) orders.push_back(backplane_order(p.u, p.v));
  std::vector<Predecessor> parents(n);
  for (std::size_t s = 0; s < n; ++s) {
    parents[s] = StrongestParent(stripes, orders, static_cast<std::int32_t>(s), tree->nodes[s].parents);
  }
  int corrections = 0;
  std::vector<int> levels(n, 0);
  std::vector<Group> groups = GroupByRoot(stripes, parents, options, &levels, &corrections);
  // The largest tree stands; smaller ones are placed by what is already there.
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.points > b.points; });
  std::vector<std::int32_t> placed;
  for (const Group& group : groups) {
    if (!placed.empty()) {
      const int offset = LevelOffset(stripes, orders, group, placed, levels);
      for (const std::int32_t i : group.members) levels[static_cast<std::size_t>(i)] += offset;
      ++corrections;
    }
    placed.insert(placed.end(), group.members.begin(), group.members.end());
  }
  for (std::size_t s = 0; s < n; ++s) tree->nodes[s].level = levels[s];
  return corrections;
}

}  // namespace dorsum
