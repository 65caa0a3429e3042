// SPDX-License-Identifier: Apache-2.0
#include "stripes/object_stripes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/median.h"
#include "base/parallel.h"
#include "stripes/ridge_survey.h"

namespace dorsum {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Height of every point of a laser, mm; NaN without an order or a sheet.
std::vector<float> Heights(const LaserStripes& stripes, const DeviceOrders& orders, const Context& context) {
  std::vector<float> z(stripes.points.size(), kNan);
  ParallelFor(context, 0, static_cast<std::int64_t>(stripes.segments.size()), [&](std::int64_t s) {
    const StripeSegment& segment = stripes.segments[static_cast<std::size_t>(s)];
    if (!segment.order) return;
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
      const auto ray = orders.At(stripes.laser, static_cast<double>(p.u), static_cast<double>(p.v));
      if (ray) z[static_cast<std::size_t>(i)] = static_cast<float>(ray->HeightOf(*segment.order));
    }
  });
  return z;
}

// Standard deviation of the heights of segments that lie on the backplane, and of what lies there elsewhere,
// from the median deviation over the surveyed rows.
double BackplaneDeviation(const IndexedStripes& stripes, const std::vector<std::vector<float>>& heights,
                          const std::vector<LaserStripes>& elsewhere, const DeviceOrders& orders,
                          double least) {
  std::vector<float> all;
  for (std::size_t l = 0; l < stripes.lasers.size(); ++l) {
    const std::vector<StripePoint>& points = stripes.lasers[l].points;
    for (const StripeSegment& s : stripes.lasers[l].segments) {
      const auto from = heights[l].begin() + s.first;
      const auto low = std::count_if(from, from + s.count, [&](float z) { return std::abs(z) < least; });
      if (2 * low < s.count) continue;
      for (auto i = static_cast<std::size_t>(s.first); i < static_cast<std::size_t>(s.first + s.count); ++i) {
        const float z = std::abs(heights[l][i]);  // higher parts of the segment are the object's
        if (z < 1.5F * static_cast<float>(least) && kSurveyedRows.Has(cvRound(points[i].v))) all.push_back(z);
      }
    }
  }
  for (const LaserStripes& one : elsewhere) {
    for (const StripePoint& p : one.points) {
      const auto ray = orders.At(one.laser, static_cast<double>(p.u), static_cast<double>(p.v));
      if (ray) all.push_back(static_cast<float>(std::abs(ray->HeightOf(std::round(ray->OrderAt(0.0))))));
    }
  }
  return all.empty() ? 0.0 : 1.4826 * Median(all);
}

// The usual width of a laser's stripes on the backplane, px; 0 where too few were measured.
float UsualWidth(const LaserStripes& stripes, const std::vector<float>& z, double threshold) {
  std::vector<float> widths;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (std::abs(z[i]) < threshold && stripes.points[i].width > 0.0F)
      widths.push_back(stripes.points[i].width);
  }
  constexpr std::size_t kFew = 100;
  return widths.size() < kFew ? 0.0F : Median(widths);
}

// Takes the height of points that are too wide away: of those whose neighbours within `rows` have a larger
// median.
int DropWide(const LaserStripes& stripes, float widest, int rows, std::vector<float>* z) {
  int dropped = 0;
  for (const StripeSegment& s : stripes.segments) {
    if (!s.order) continue;
    const auto wide = [&](std::int32_t i) {
      return stripes.points[static_cast<std::size_t>(i)].width > widest ? 1 : 0;
    };
    // The median is larger where more than half are.
    std::int32_t first = s.first, end = s.first, count = 0;
    for (std::int32_t i = s.first; i < s.first + s.count; ++i) {
      for (; end < std::min(s.first + s.count, i + rows / 2 + 1); ++end) count += wide(end);
      for (; first < i - rows / 2; ++first) count -= wide(first);
      if (2 * count <= end - first) continue;
      (*z)[static_cast<std::size_t>(i)] = kNan;
      ++dropped;
    }
  }
  return dropped;
}

enum class Place { kObject, kBackplane, kNeither };
struct Run {
  std::int32_t first = 0, count = 0;
  Place place = Place::kNeither;
};

// Runs of points of one segment, joined where they are too short to be true.
std::vector<Run> FindRuns(const StripeSegment& segment, const std::vector<float>& z, double threshold,
                          const ObjectSplitOptions& options) {
  std::vector<Run> runs;
  const auto append = [&](Run run) {
    if (!runs.empty() && runs.back().place == run.place) {
      runs.back().count += run.count;
    } else {
      runs.push_back(run);
    }
  };
  for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
    const double height = z[static_cast<std::size_t>(i)];
    append({i, 1,
            height > threshold     ? Place::kObject
            : height >= -threshold ? Place::kBackplane
                                   : Place::kNeither});
  }
  const auto rejoin = [&](auto&& place_of) {
    std::vector<Run> old = std::exchange(runs, {});
    for (std::size_t r = 0; r < old.size(); ++r) append({old[r].first, old[r].count, place_of(old, r)});
  };
  rejoin([&](const std::vector<Run>& old, std::size_t r) {
    const bool dip = old[r].place == Place::kBackplane && old[r].count <= options.short_dip_rows && r > 0 &&
                     r + 1 < old.size() && old[r - 1].place == Place::kObject &&
                     old[r + 1].place == Place::kObject;
    return dip ? Place::kObject : old[r].place;
  });
  rejoin([&](const std::vector<Run>& old, std::size_t r) {
    if (old[r].place != Place::kObject || old[r].count >= options.short_rows) return old[r].place;
    const auto from = z.begin() + old[r].first;
    const bool high = *std::max_element(from, from + old[r].count) > options.short_height_mm;
    // What leans on nothing is judged by its height alone; beside the backplane it may be the edge's light.
    return high ? Place::kObject : Place::kBackplane;
  });
  return runs;
}

// Adds points [first, first + count) of `from` to `to` as a segment of their own.
void AppendSegment(const LaserStripes& from, const StripeSegment& segment, std::int32_t first,
                   std::int32_t count, std::vector<std::int32_t>* moved, LaserStripes* to) {
  StripeSegment s;
  s.first = static_cast<std::int32_t>(to->points.size());
  s.count = count;
  s.order = segment.order;
  double peak = 0.0;
  for (std::int32_t i = first; i < first + count; ++i) {
    StripePoint p = from.points[static_cast<std::size_t>(i)];
    (*moved)[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(to->points.size());
    p.segment = static_cast<std::int32_t>(to->segments.size());
    s.min_u = i == first ? p.u : std::min(s.min_u, p.u);
    s.max_u = i == first ? p.u : std::max(s.max_u, p.u);
    s.min_v = i == first ? p.v : std::min(s.min_v, p.v);
    s.max_v = i == first ? p.v : std::max(s.max_v, p.v);
    peak += p.peak;
    to->points.push_back(p);
  }
  s.mean_peak = static_cast<float>(peak / count);
  to->segments.push_back(s);
}

// What one laser contributes to an ObjectSplit.
struct LaserSplit {
  LaserStripes object;
  std::vector<StripePoint> backplane;
  int wide = 0, below = 0;
};

LaserSplit SplitLaser(const LaserStripes& from, double threshold_mm, const ObjectSplitOptions& options,
                      std::vector<float> z) {
  LaserSplit out;
  const float width = UsualWidth(from, z, threshold_mm);
  if (width > 0.0F) {
    out.wide = DropWide(from, static_cast<float>(options.max_width_ratio) * width, options.width_rows, &z);
  }
  LaserStripes& to = out.object;
  to.laser = from.laser;
  std::vector<std::int32_t> moved(from.points.size(), kNoPoint);
  for (const StripeSegment& segment : from.segments) {
    if (!segment.order) continue;
    for (const Run& run : FindRuns(segment, z, threshold_mm, options)) {
      if (run.place == Place::kObject) AppendSegment(from, segment, run.first, run.count, &moved, &to);
      if (run.place == Place::kNeither) {
        const auto first = z.begin() + run.first;
        out.below +=
            static_cast<int>(std::count_if(first, first + run.count, [](float x) { return !std::isnan(x); }));
      }
      if (run.place != Place::kBackplane) continue;
      const auto first = from.points.begin() + run.first;
      out.backplane.insert(out.backplane.end(), first, first + run.count);
    }
  }
  const auto where = [&](std::int32_t i) {
    return i == kNoPoint ? kNoPoint : moved[static_cast<std::size_t>(i)];
  };
  for (StripePoint& p : to.points) {
    p.left = where(p.left);
    p.right = where(p.right);
    p.top = where(p.top);
    p.bottom = where(p.bottom);
  }
  return out;
}

}  // namespace

ObjectSplit SplitByHeight(const IndexedStripes& stripes, const std::vector<LaserStripes>& elsewhere,
                          const DeviceOrders& orders, const ObjectSplitOptions& options,
                          const Context& context) {
  ObjectSplit out;
  std::vector<std::vector<float>> heights;
  heights.reserve(stripes.lasers.size());
  for (const LaserStripes& one : stripes.lasers) heights.push_back(Heights(one, orders, context));
  out.backplane_sd_mm = BackplaneDeviation(stripes, heights, elsewhere, orders, options.min_height_mm);
  out.threshold_mm = std::max(options.min_height_mm, options.noise_factor * out.backplane_sd_mm);
  out.object.diagnostics = stripes.diagnostics;
  std::vector<LaserSplit> splits(stripes.lasers.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(splits.size()), [&](std::int64_t i) {
    const auto l = static_cast<std::size_t>(i);
    splits[l] = SplitLaser(stripes.lasers[l], out.threshold_mm, options, std::move(heights[l]));
  });
  for (const LaserStripes& one : elsewhere)
    out.backplane.insert(out.backplane.end(), one.points.begin(), one.points.end());
  for (LaserSplit& split : splits) {
    out.object.lasers.push_back(std::move(split.object));
    out.backplane.insert(out.backplane.end(), split.backplane.begin(), split.backplane.end());
    out.wide += split.wide;
    out.below += split.below;
  }
  return out;
}

}  // namespace dorsum
