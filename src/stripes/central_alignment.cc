// SPDX-License-Identifier: Apache-2.0
#include "stripes/central_alignment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace dorsum {
namespace {

struct Level {
  double peak = 0.0;  // sum, then mean, over its points
  double bottom = 0.0,
         top = 0.0;  // sums, then means, of its points' orders at the ends of the working volume
  double points = 0.0;
};

std::map<int, Level> SummariseLevels(const StripeTree& tree, const OrderRange& range,
                                     const LaserStripes& stripes) {
  std::map<int, Level> levels;
  for (std::size_t s = 0; s < stripes.segments.size(); ++s) {
    const StripeSegment& segment = stripes.segments[s];
    Level& level = levels[tree.nodes[s].level];
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
      const auto [bottom, top] = range(p.u, p.v);
      level.peak += p.peak;
      level.bottom += bottom;
      level.top += top;
      level.points += 1.0;
    }
  }
  for (auto& [index, level] : levels) {
    level.peak /= level.points;
    level.bottom /= level.points;
    level.top /= level.points;
  }
  return levels;
}

// A central order stands out against its neighbours: the mean of those that are there.
double RatioToNeighbours(const std::map<int, Level>& levels, int index) {
  double sum = 0.0;
  int count = 0;
  for (const int neighbour : {index - 1, index + 1}) {
    const auto it = levels.find(neighbour);
    if (it == levels.end()) continue;
    sum += it->second.peak;
    ++count;
  }
  return count == 0 || sum <= 0.0 ? 0.0 : levels.at(index).peak * count / sum;
}

double MedianPoints(const std::map<int, Level>& levels) {
  std::vector<double> points;
  for (const auto& [index, level] : levels) points.push_back(level.points);
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  std::nth_element(points.begin(), middle, points.end());
  return *middle;
}

}  // namespace

int AlignToCentralStripe(const StripeTree& tree, const OrderRange& range,
                         const CentralAlignmentOptions& options, LaserStripes* stripes) {
  const std::map<int, Level> levels = SummariseLevels(tree, range, *stripes);
  if (levels.empty()) return 0;
  constexpr double kSlack = 0.2;  // orders: surfaces may touch the ends of the working volume
  const double least_points = options.min_points_share * MedianPoints(levels);
  int central = 0;
  double brightest = -1.0;
  for (const auto& [index, level] : levels) {
    const auto [low, high] = std::minmax(level.bottom, level.top);
    const bool possible = low - kSlack <= 0.0 && high + kSlack >= 0.0;
    if (!possible || level.points < least_points || level.peak <= brightest) continue;
    if (RatioToNeighbours(levels, index) < options.min_ratio) continue;
    brightest = level.peak;
    central = index;
  }
  if (brightest < 0.0) {
    // No central stripe on the object: the largest level takes the order that puts it lowest in the volume.
    const auto largest = std::max_element(levels.begin(), levels.end(), [](const auto& a, const auto& b) {
      return a.second.points < b.second.points;
    });
    const Level& level = largest->second;
    const double order =
        level.top > level.bottom ? std::ceil(level.bottom - kSlack) : std::floor(level.bottom + kSlack);
    central = largest->first - static_cast<int>(order);
  }
  for (std::size_t s = 0; s < stripes->segments.size(); ++s) {
    stripes->segments[s].order = tree.nodes[s].level - central;
  }
  return central;
}

}  // namespace dorsum
