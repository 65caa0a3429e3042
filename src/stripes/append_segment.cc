// SPDX-License-Identifier: Apache-2.0
#include "stripes/append_segment.h"

#include <algorithm>
#include <stdexcept>

namespace dorsum {

void AppendSegment(std::span<const StripePoint> points, std::optional<int> order, LaserStripes* out) {
  if (points.empty()) return;
  StripeSegment s;
  s.order = order;
  s.first = static_cast<std::int32_t>(out->points.size());
  s.count = static_cast<std::int32_t>(points.size());
  s.min_u = s.max_u = points.front().u;
  s.min_v = points.front().v;
  s.max_v = points.back().v;
  double peaks = 0.0;
  out->points.insert(out->points.end(), points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto index = s.first + static_cast<std::int32_t>(i);
    StripePoint& p = out->points[static_cast<std::size_t>(index)];
    p.segment = static_cast<std::int32_t>(out->segments.size());
    p.top = i > 0 ? index - 1 : kNoPoint;
    p.bottom = i + 1 < points.size() ? index + 1 : kNoPoint;
    s.min_u = std::min(s.min_u, p.u);
    s.max_u = std::max(s.max_u, p.u);
    peaks += p.peak;
  }
  s.mean_peak = static_cast<float>(peaks / static_cast<double>(points.size()));
  out->segments.push_back(s);
}

LaserStripes KeepPoints(const LaserStripes& stripes, std::span<const char> keep) {
  if (keep.size() != stripes.points.size()) throw std::logic_error("KeepPoints: one entry per point");
  LaserStripes out;
  out.laser = stripes.laser;
  out.points.reserve(stripes.points.size());
  for (const StripeSegment& s : stripes.segments) {
    const auto first = static_cast<std::size_t>(s.first), end = first + static_cast<std::size_t>(s.count);
    for (std::size_t begin = first; begin < end;) {
      std::size_t stop = begin;
      while (stop < end && keep[stop] == keep[begin]) ++stop;
      if (keep[begin] != 0) {
        const std::size_t before = out.points.size();
        AppendSegment({stripes.points.data() + begin, stop - begin}, s.order, &out);
        for (std::size_t i = before; i < out.points.size(); ++i) {
          out.points[i].left = out.points[i].right = kNoPoint;
        }
      }
      begin = stop;
    }
  }
  return out;
}

void UpdateExtremes(LaserStripes* stripes) {
  for (StripeSegment& segment : stripes->segments) {
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      const float u = stripes->points[static_cast<std::size_t>(i)].u;
      segment.min_u = i == segment.first ? u : std::min(segment.min_u, u);
      segment.max_u = i == segment.first ? u : std::max(segment.max_u, u);
    }
  }
}

}  // namespace dorsum
