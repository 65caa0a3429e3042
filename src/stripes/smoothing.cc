// SPDX-License-Identifier: Apache-2.0
#include "stripes/smoothing.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "stripes/append_segment.h"

namespace dorsum {
namespace {

// Value at point i of the line fitted to its neighbourhood, and how much the fit reduces its variance.
struct Fitted {
  double u = 0.0;
  double variance_factor = 1.0;
};

Fitted FitLine(std::span<const StripePoint> points, std::size_t i, int half_window) {
  const auto n = static_cast<std::int64_t>(points.size());
  const auto at = static_cast<std::int64_t>(i);
  const std::int64_t begin = std::max<std::int64_t>(0, at - half_window);
  const std::int64_t end = std::min<std::int64_t>(n, at + half_window + 1);
  double s0 = 0.0, s1 = 0.0, s2 = 0.0, t0 = 0.0, t1 = 0.0;
  for (std::int64_t j = begin; j < end; ++j) {
    const StripePoint& p = points[static_cast<std::size_t>(j)];
    const double dv = p.v - points[i].v;
    s0 += 1.0;
    s1 += dv;
    s2 += dv * dv;
    t0 += p.u;
    t1 += p.u * dv;
  }
  const double det = s0 * s2 - s1 * s1;
  if (det < 1e-9) return {points[i].u, 1.0};
  return {(t0 * s2 - t1 * s1) / det, s2 / det};
}

void AppendSmoothed(std::span<const StripePoint> piece, const SmoothingOptions& options, LaserStripes* out) {
  std::vector<StripePoint> points(piece.begin(), piece.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Fitted fitted = FitLine(piece, i, options.half_window_rows);
    points[i].u = static_cast<float>(fitted.u);
    points[i].sd_px = static_cast<float>(points[i].sd_px * std::sqrt(fitted.variance_factor));
  }
  AppendSegment(points, std::nullopt, out);
}

}  // namespace

LaserStripes SmoothSegments(const LaserStripes& stripes, int min_rows, const SmoothingOptions& options) {
  LaserStripes out;
  out.laser = stripes.laser;
  for (const StripeSegment& s : stripes.segments) {
    const std::span<const StripePoint> all(stripes.points.data() + s.first,
                                           static_cast<std::size_t>(s.count));
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= all.size(); ++i) {
      const bool parts = i == all.size() || std::abs(all[i].u - all[i - 1].u) > options.max_step_px ||
                         all[i].v - all[i - 1].v > 1.5F;
      if (!parts) continue;
      if (i - begin >= static_cast<std::size_t>(min_rows))
        AppendSmoothed(all.subspan(begin, i - begin), options, &out);
      begin = i;
    }
  }
  return out;
}

}  // namespace dorsum
