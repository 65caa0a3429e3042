// SPDX-License-Identifier: Apache-2.0
#include "stripes/segment_linking.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include "stripes/append_segment.h"

namespace dorsum {
namespace {

// A segment that may still grow.
struct Track {
  std::vector<StripePoint> points;
  double slope = 0.0;      // px per row
  double mean_peak = 0.0;  // of the last rows
  double expected = 0.0;   // u in the row at hand
};

void Update(const SegmentLinkingOptions& options, Track* track) {
  const std::vector<StripePoint>& p = track->points;
  const std::size_t n = std::min(p.size(), static_cast<std::size_t>(options.slope_rows));
  double sv = 0.0, su = 0.0, svv = 0.0, suv = 0.0, peak = 0.0;
  const auto v0 = static_cast<double>(p.back().v), u0 = static_cast<double>(p.back().u);
  for (std::size_t i = p.size() - n; i < p.size(); ++i) {
    const double v = static_cast<double>(p[i].v) - v0, u = static_cast<double>(p[i].u) - u0;
    sv += v;
    su += u;
    svv += v * v;
    suv += u * v;
    peak += static_cast<double>(p[i].peak);
  }
  const auto count = static_cast<double>(n);
  // A young track's slope is drawn towards upright.
  const double spread = svv - sv * sv / count + 4.0;
  track->slope = std::clamp((suv - su * sv / count) / spread, -options.max_slope, options.max_slope);
  track->mean_peak = peak / count;
  track->expected = u0 + (su - track->slope * sv) / count;
}

double Expected(const Track& track, double row) {
  return track.expected + track.slope * (row - static_cast<double>(track.points.back().v));
}

// A possible continuation.
struct Pair {
  double distance = 0.0;
  std::size_t track = 0, point = 0;
};

void PairsOfRow(const std::vector<Track>& tracks, const std::vector<StripePoint>& points, double row,
                const SegmentLinkingOptions& options, std::vector<Pair>* pairs) {
  pairs->clear();
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const double expected = Expected(tracks[t], row);
    const double reach = 20.0;
    auto it = std::lower_bound(points.begin(), points.end(), expected - reach,
                               [](const StripePoint& p, double u) { return static_cast<double>(p.u) < u; });
    for (; it != points.end() && static_cast<double>(it->u) < expected + reach; ++it) {
      const double distance = std::abs(static_cast<double>(it->u) - expected);
      const double gate = options.gate_px + options.gate_share * static_cast<double>(it->width) +
                          0.5 * std::abs(tracks[t].slope);
      if (distance > gate) continue;
      const double ratio = static_cast<double>(it->peak) / tracks[t].mean_peak;
      if (ratio > options.max_brightness || ratio < 1.0 / options.max_brightness) continue;
      pairs->push_back({distance, t, static_cast<std::size_t>(it - points.begin())});
    }
  }
  std::sort(pairs->begin(), pairs->end(), [](const Pair& p, const Pair& q) {
    return std::tie(p.distance, p.track, p.point) < std::tie(q.distance, q.track, q.point);
  });
}

}  // namespace

LaserStripes AssembleStripes(const std::vector<std::vector<StripePoint>>& segments, int laser) {
  LaserStripes out;
  out.laser = laser;
  std::size_t count = 0;
  for (const std::vector<StripePoint>& points : segments) count += points.size();
  out.points.reserve(count);
  for (const std::vector<StripePoint>& points : segments) {
    AppendSegment(points, std::nullopt, &out);
  }
  return out;
}

LaserStripes LinkSegments(const std::vector<std::vector<StripePoint>>& rows, int laser,
                          const SegmentLinkingOptions& options) {
  std::vector<Track> open;
  std::vector<std::vector<StripePoint>> done;
  std::vector<Pair> pairs;
  std::vector<char> track_taken, point_taken;
  const auto close = [&](Track* track) {
    if (static_cast<int>(track->points.size()) >= options.min_rows) done.push_back(std::move(track->points));
  };
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::vector<StripePoint>& points = rows[row];
    std::size_t kept = 0;
    for (Track& track : open) {
      const auto missing = static_cast<double>(row) - 1.0 - static_cast<double>(track.points.back().v);
      if (missing > options.max_gap_rows) {
        close(&track);
      } else {
        if (&open[kept] != &track) open[kept] = std::move(track);
        ++kept;
      }
    }
    open.resize(kept);
    PairsOfRow(open, points, static_cast<double>(row), options, &pairs);
    track_taken.assign(open.size(), 0);
    point_taken.assign(points.size(), 0);
    for (const Pair& pair : pairs) {
      if (track_taken[pair.track] != 0 || point_taken[pair.point] != 0) continue;
      track_taken[pair.track] = point_taken[pair.point] = 1;
      open[pair.track].points.push_back(points[pair.point]);
      Update(options, &open[pair.track]);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (point_taken[i] != 0) continue;
      Track track;
      track.points.push_back(points[i]);
      Update(options, &track);
      open.push_back(std::move(track));
    }
  }
  for (Track& track : open) close(&track);
  std::stable_sort(
      done.begin(), done.end(), [](const std::vector<StripePoint>& p, const std::vector<StripePoint>& q) {
        return p.front().v < q.front().v || (p.front().v == q.front().v && p.front().u < q.front().u);
      });
  return AssembleStripes(done, laser);
}

}  // namespace dorsum
