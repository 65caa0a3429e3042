// SPDX-License-Identifier: Apache-2.0
#include "stripes/smoothing.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

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

void AppendSegment(std::span<const StripePoint> piece, const SmoothingOptions& options, LaserStripes* out) {
  const auto first = static_cast<std::int32_t>(out->points.size());
  const auto count = static_cast<std::int32_t>(piece.size());
  StripeSegment s;
  s.first = first;
  s.count = count;
  s.min_u = s.max_u = piece.front().u;
  s.min_v = piece.front().v;
  s.max_v = piece.back().v;
  double peaks = 0.0;
  for (std::int32_t i = 0; i < count; ++i) {
    StripePoint p = piece[static_cast<std::size_t>(i)];
    const Fitted fitted = FitLine(piece, static_cast<std::size_t>(i), options.half_window_rows);
    p.u = static_cast<float>(fitted.u);
    p.sd_px = static_cast<float>(p.sd_px * std::sqrt(fitted.variance_factor));
    p.segment = static_cast<std::int32_t>(out->segments.size());
    p.top = i > 0 ? first + i - 1 : kNoPoint;
    p.bottom = i + 1 < count ? first + i + 1 : kNoPoint;
    s.min_u = std::min(s.min_u, p.u);
    s.max_u = std::max(s.max_u, p.u);
    peaks += p.peak;
    out->points.push_back(p);
  }
  s.mean_peak = static_cast<float>(peaks / count);
  out->segments.push_back(s);
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
        AppendSegment(all.subspan(begin, i - begin), options, &out);
      begin = i;
    }
  }
  return out;
}

}  // namespace dorsum
