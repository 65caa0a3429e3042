// SPDX-License-Identifier: Apache-2.0
#include "stripes/brightness_pull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

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
  // Sums over the rows before each, from which those over any window follow.
  struct Sums {
    double v = 0.0, l = 0.0, vv = 0.0, vl = 0.0, ll = 0.0;
  };
  std::vector<Sums> before(points.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double v = static_cast<double>(points[i].v - points.front().v), l = level[i] - level.front();
    const Sums& s = before[i];
    before[i + 1] = {s.v + v, s.l + l, s.vv + v * v, s.vl + v * l, s.ll + l * l};
  }
  // Of the rows around row k, up to `half` away, the first and the one behind the last.
  const auto window = [n = points.size()](std::size_t k, int half) {
    const auto reach = static_cast<std::size_t>(half);
    return std::pair(k < reach ? 0 : k - reach, std::min(n, k + reach + 1));
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [first, end] = window(k, options.half_rows);
    const auto count = static_cast<double>(end - first);
    const Sums &s = before[end], &t = before[first];
    const double v = s.v - t.v, l = s.l - t.l;
    const double vv = s.vv - t.vv - v * v / count, vl = s.vl - t.vl - v * l / count;
    const double ll = s.ll - t.ll - l * l / count;
    const double slope = vl / vv;
    // What the scatter about the line, alike in some neighbouring rows, makes of the slope by chance.
    const double chance = 4.0 * std::max(0.0, ll - slope * vl) / std::max(1.0, count - 2.0) / vv;
    squares[k] = slope * slope - chance;
    if (slope * slope > 4.0 * chance) sure[k] = slope * slope - chance;
  }
  // Where the brightness happens to stand still along the stripe, it may still change across it: the mean
  // over a wider stretch speaks for the rows that show less.
  std::vector<double> sum = {0.0};
  for (const double square : squares) sum.push_back(sum.back() + square);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [first, end] = window(k, options.wide_half_rows);
    const double mean = (sum[end] - sum[first]) / static_cast<double>(end - first);
    pull[k] = options.across_share * width * width * std::sqrt(std::max({0.0, sure[k], mean}));
  }
  return pull;
}

}  // namespace dorsum
