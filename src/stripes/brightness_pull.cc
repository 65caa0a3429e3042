// SPDX-License-Identifier: Apache-2.0
#include "stripes/brightness_pull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/median.h"

namespace dorsum {
namespace {

double MedianWidth(const std::vector<StripePoint>& points) {
  std::vector<float> widths;
  widths.reserve(points.size());
  for (const StripePoint& p : points) widths.push_back(p.width);
  return static_cast<double>(Median(std::move(widths)));
}

}  // namespace

std::vector<double> BrightnessPull(const std::vector<StripePoint>& points,
                                   const BrightnessPullOptions& options) {
  std::vector<double> pull(points.size(), 0.0);
  if (points.size() < 6) return pull;
  const double width = MedianWidth(points);
  std::vector<double> level;
  level.reserve(points.size());
  for (const StripePoint& p : points) level.push_back(std::log(std::max(0.5, static_cast<double>(p.peak))));
  std::vector<double> squares(points.size(), 0.0), sure(points.size(), 0.0);
  const auto n = static_cast<std::ptrdiff_t>(points.size());
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, k - options.half_rows);
    const std::ptrdiff_t last = std::min<std::ptrdiff_t>(n - 1, k + options.half_rows);
    const double count = static_cast<double>(last - first) + 1.0;
    double mean_v = 0.0, mean_level = 0.0;
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      mean_v += static_cast<double>(points[static_cast<std::size_t>(i)].v);
      mean_level += level[static_cast<std::size_t>(i)];
    }
    mean_v /= count;
    mean_level /= count;
    double vv = 0.0, vl = 0.0, ll = 0.0;
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      const double v = static_cast<double>(points[static_cast<std::size_t>(i)].v) - mean_v;
      const double l = level[static_cast<std::size_t>(i)] - mean_level;
      vv += v * v;
      vl += v * l;
      ll += l * l;
    }
    const double slope = vl / vv;
    // What the scatter about the line, alike in some neighbouring rows, makes of the slope by chance.
    const double chance = 4.0 * std::max(0.0, ll - slope * vl) / std::max(1.0, count - 2.0) / vv;
    squares[static_cast<std::size_t>(k)] = slope * slope - chance;
    if (slope * slope > 4.0 * chance) sure[static_cast<std::size_t>(k)] = slope * slope - chance;
  }
  // Where the brightness happens to stand still along the stripe, it may still change across it: the mean
  // over a wider stretch speaks for the rows that show less.
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, k - options.wide_half_rows);
    const std::ptrdiff_t last = std::min<std::ptrdiff_t>(n - 1, k + options.wide_half_rows);
    double mean = 0.0;
    for (std::ptrdiff_t i = first; i <= last; ++i) mean += squares[static_cast<std::size_t>(i)];
    mean /= static_cast<double>(last - first) + 1.0;
    const double own = sure[static_cast<std::size_t>(k)];
    pull[static_cast<std::size_t>(k)] =
        options.across_share * width * width * std::sqrt(std::max({0.0, own, mean}));
  }
  return pull;
}

}  // namespace dorsum
