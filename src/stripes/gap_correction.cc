// SPDX-License-Identifier: Apache-2.0
#include "stripes/gap_correction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace dorsum {
namespace {

double Median(std::vector<double>* values) {
  const auto middle = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

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
    best = {parent, Median(&values)};
  }
  return best;
}

// A stripe without a predecessor in its rows: the nearest already indexed one, wherever it stands.
Predecessor NearestIndexed(const std::vector<double>& mean_order, const LaserStripes& stripes,
                           std::int32_t segment, const std::vector<std::int32_t>& indexed) {
  const StripeSegment& s = stripes.segments[static_cast<std::size_t>(segment)];
  Predecessor best;
  double least = std::numeric_limits<double>::max();
  for (const std::int32_t other : indexed) {
    const StripeSegment& o = stripes.segments[static_cast<std::size_t>(other)];
    const double rows = std::max({0.0F, o.min_v - s.max_v, s.min_v - o.max_v});
    const double columns = std::max({0.0F, o.min_u - s.max_u, s.min_u - o.max_u});
    const double distance = std::hypot(rows, columns);
    if (distance >= least) continue;
    least = distance;
    best = {other,
            mean_order[static_cast<std::size_t>(segment)] - mean_order[static_cast<std::size_t>(other)]};
  }
  return best;
}

// The segment with those of its line of ancestors that were not reached before, the oldest first: a stripe on
// a slope can lie further right on the backplane's scale than its child.
std::vector<std::int32_t> UnreachedAncestors(const std::vector<Predecessor>& parents, std::int32_t segment,
                                             std::vector<char>* reached) {
  std::vector<std::int32_t> line;
  for (std::int32_t i = segment; i != kNoPoint; i = parents[static_cast<std::size_t>(i)].segment) {
    char& seen = (*reached)[static_cast<std::size_t>(i)];
    if (seen != 0) break;
    seen = 1;
    line.push_back(i);
  }
  std::reverse(line.begin(), line.end());
  return line;
}

}  // namespace

int CorrectGaps(const LaserStripes& stripes, const BackplaneOrder& backplane_order,
                const GapCorrectionOptions& options, StripeTree* tree) {
  const std::size_t n = stripes.segments.size();
  std::vector<double> orders(stripes.points.size());
  for (std::size_t i = 0; i < orders.size(); ++i)
    orders[i] = backplane_order(stripes.points[i].u, stripes.points[i].v);
  std::vector<double> mean_order(n, 0.0);
  for (std::size_t s = 0; s < n; ++s) {
    const StripeSegment& segment = stripes.segments[s];
    const auto begin = orders.begin() + segment.first;
    mean_order[s] = std::accumulate(begin, begin + segment.count, 0.0) / segment.count;
  }
  std::vector<std::int32_t> by_place(n), indexed;
  std::iota(by_place.begin(), by_place.end(), 0);
  std::stable_sort(by_place.begin(), by_place.end(), [&](std::int32_t i, std::int32_t j) {
    return mean_order[static_cast<std::size_t>(i)] < mean_order[static_cast<std::size_t>(j)];
  });
  std::vector<Predecessor> parents(n);
  for (std::size_t s = 0; s < n; ++s) {
    parents[s] = StrongestParent(stripes, orders, static_cast<std::int32_t>(s), tree->nodes[s].parents);
  }
  int corrections = 0;
  std::vector<char> reached(n, 0);
  for (const std::int32_t i : by_place) {
    // Going from left to right, the corrected level of the predecessor propagates to its children here.
    for (const std::int32_t k : UnreachedAncestors(parents, i, &reached)) {
      const auto index = static_cast<std::size_t>(k);
      Predecessor p = parents[index];
      const bool has_parent = p.segment != kNoPoint;
      if (!has_parent && !indexed.empty()) p = NearestIndexed(mean_order, stripes, k, indexed);
      if (p.segment != kNoPoint) {
        const int steps =
            has_parent && p.spacings <= options.max_spacings ? 1 : static_cast<int>(std::lround(p.spacings));
        tree->nodes[index].level = tree->nodes[static_cast<std::size_t>(p.segment)].level + steps;
        if (steps != 1) ++corrections;
      }
      indexed.push_back(k);
    }
  }
  return corrections;
}

}  // namespace dorsum
