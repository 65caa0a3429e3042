// SPDX-License-Identifier: Apache-2.0
#include "stripes/central_alignment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/median.h"

namespace dorsum {
namespace {

// All points of one level: sums while collecting, then means.
struct Level {
  double log_peak = 0.0;
  double bottom = 0.0, top = 0.0;  // orders at the ends of the working volume
  double points = 0.0;
};
using Levels = std::map<int, Level>;

Levels SummariseLevels(const StripeTree& tree, const OrderRange& range, const LaserStripes& stripes) {
  Levels levels;
  for (std::size_t s = 0; s < stripes.segments.size(); ++s) {
    const StripeSegment& segment = stripes.segments[s];
    Level& level = levels[tree.nodes[s].level];
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
      const auto [bottom, top] = range(p.u, p.v);
      level.log_peak += std::log(std::max(1.0F, p.peak));
      level.bottom += bottom;
      level.top += top;
      level.points += 1.0;
    }
  }
  for (auto& [index, level] : levels) {
    level.log_peak /= level.points;
    level.bottom /= level.points;
    level.top /= level.points;
  }
  return levels;
}

// What the brightness of a level says of its being the central one.
// Its dimness says nothing: a slope or an edge can dim it.
enum class Evidence { kNone, kFor };

// What speaks for the level `central` being order 0.
struct Candidate {
  int central = 0;
  Evidence evidence = Evidence::kNone;
  double in_volume = 0.0;  // share of points
  double mismatch = 0.0;   // of brightness: standard deviation of a logarithm
  double height = 0.0;     // mean place in the working volume, 0 bottom, 1 top
};

double MedianPoints(const Levels& levels) {
  std::vector<double> points;
  for (const auto& [index, level] : levels) points.push_back(level.points);
  return Median(std::move(points));
}

// Does the level stand out against those beside it, as order 0 does on the backplane?
Evidence Contrast(const Levels& levels, const ReferencePeak& reference_peak, int central,
                  const CentralAlignmentOptions& options) {
  const double least = options.min_points_share * MedianPoints(levels);
  const auto here = levels.find(central);
  if (here == levels.end() || here->second.points < least) return Evidence::kNone;
  double seen = 0.0, expected = 0.0;
  int neighbours = 0;
  for (const int side : {-1, 1}) {
    const auto beside = levels.find(central + side);
    if (beside == levels.end() || beside->second.points < least) continue;
    seen += here->second.log_peak - beside->second.log_peak;
    expected += std::log(reference_peak(0) / reference_peak(side));
    ++neighbours;
  }
  if (neighbours == 0) return Evidence::kNone;
  // One neighbour alone proves less than two.
  const double needed = neighbours == 2 ? options.min_contrast : 0.5 * (1.0 + options.min_contrast);
  return seen >= needed * expected ? Evidence::kFor : Evidence::kNone;
}

Candidate Judge(const Levels& levels, const ReferencePeak& reference_peak, int central,
                const CentralAlignmentOptions& options) {
  constexpr double kSlack = 0.1;  // orders: surfaces may touch the ends of the working volume
  Candidate c;
  c.central = central;
  c.evidence = Contrast(levels, reference_peak, central, options);
  double points = 0.0, inside = 0.0, sum = 0.0, squares = 0.0;
  for (const auto& [index, level] : levels) {
    const int order = index - central;
    const auto [low, high] = std::minmax(level.bottom, level.top);
    points += level.points;
    if (order < low - kSlack || order > high + kSlack) continue;
    inside += level.points;
    const double ratio = level.log_peak - std::log(std::max(1e-6, reference_peak(order)));
    sum += level.points * ratio;
    squares += level.points * ratio * ratio;
    c.height += level.points * (order - level.bottom) / (level.top - level.bottom);
  }
  if (inside <= 0.0) return c;
  c.in_volume = inside / points;
  c.height /= inside;
  c.mismatch = std::sqrt(std::max(0.0, squares / inside - std::pow(sum / inside, 2)));
  return c;
}

std::vector<Candidate> Candidates(const Levels& levels, const ReferencePeak& reference_peak,
                                  const CentralAlignmentOptions& options) {
  // Every numbering that puts some level into the working volume.
  int first = 0, last = 0;
  bool any = false;
  for (const auto& [index, level] : levels) {
    const auto [low, high] = std::minmax(level.bottom, level.top);
    const int from = index - static_cast<int>(std::ceil(high)),
              to = index - static_cast<int>(std::floor(low));
    first = any ? std::min(first, from) : from;
    last = any ? std::max(last, to) : to;
    any = true;
  }
  constexpr int kMost = 1000;  // a working volume that reaches the grating would make this endless
  last = std::min(last, first + kMost);
  std::vector<Candidate> all;
  double most = 0.0;
  for (int central = first; central <= last; ++central) {
    all.push_back(Judge(levels, reference_peak, central, options));
    most = std::max(most, all.back().in_volume);
  }
  std::erase_if(all, [&](const Candidate& c) { return c.in_volume < std::min(options.min_in_volume, most); });
  return all;
}

}  // namespace

int AlignToCentralStripe(const StripeTree& tree, const OrderRange& range, const ReferencePeak& reference_peak,
                         const CentralAlignmentOptions& options, LaserStripes* stripes) {
  const Levels levels = SummariseLevels(tree, range, *stripes);
  if (levels.empty()) return 0;
  const std::vector<Candidate> candidates = Candidates(levels, reference_peak, options);
  const auto better = [](const Candidate& a, const Candidate& b) {
    if (a.evidence != b.evidence) return a.evidence > b.evidence;
    return a.evidence == Evidence::kFor ? a.mismatch < b.mismatch : a.height < b.height;
  };
  const Candidate& chosen = *std::min_element(candidates.begin(), candidates.end(), better);
  for (std::size_t s = 0; s < stripes->segments.size(); ++s) {
    stripes->segments[s].order = tree.nodes[s].level - chosen.central;
  }
  return chosen.central;
}

}  // namespace dorsum
