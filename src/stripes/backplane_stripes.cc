// SPDX-License-Identifier: Apache-2.0
#include "stripes/backplane_stripes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "stripes/append_segment.h"

namespace dorsum {
namespace {

const ReferenceStripe* NearestReference(const LaserGeometry& laser, const StripePoint& p,
                                        double max_distance_px) {
  const ReferenceStripe* nearest = nullptr;
  double least = max_distance_px;
  for (const ReferenceStripe& r : laser.reference) {
    if (!r.Covers(p.v)) continue;
    const double distance = std::abs(r.ColumnAt(p.v) - p.u);
    if (distance > least) continue;
    least = distance;
    nearest = &r;
  }
  return nearest;
}

enum class Place : char { kFree, kDim, kBackplane };  // off any reference stripe; on one but dimmer; on one

// For each point of a segment: does it lie on a reference stripe, and is it on average as bright as one
// there?
std::vector<Place> FindPlaces(std::span<const StripePoint> points, const LaserGeometry& laser,
                              const BackplaneStripeOptions& options) {
  std::vector<double> ratio(points.size(), -1.0);  // brightness over the reference's, or no reference
  std::vector<char> close(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ReferenceStripe* r = NearestReference(laser, points[i], options.vote_distance_px);
    if (r == nullptr) continue;
    ratio[i] = points[i].peak / std::max(1.0, r->PeakAt(points[i].v));
    close[i] = std::abs(r->ColumnAt(points[i].v) - points[i].u) <= options.max_distance_px ? 1 : 0;
  }
  const auto half = static_cast<std::size_t>(options.window_rows / 2);
  std::vector<Place> out(points.size(), Place::kFree);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ratio[i] < 0.0) continue;
    double sum = 0.0, count = 0.0;
    for (std::size_t k = i > half ? i - half : 0; k < std::min(points.size(), i + half + 1); ++k) {
      if (ratio[k] < 0.0) continue;
      sum += ratio[k];
      count += 1.0;
    }
    const double mean = sum / count;
    if (mean > options.max_brightness) continue;
    const bool bright = mean >= options.min_brightness;
    out[i] = !bright ? Place::kDim : close[i] ? Place::kBackplane : Place::kFree;
  }
  return out;
}

// All points by image row, for looking at what stands beside a point.
struct Neighbour {
  float u = 0.0F;
  std::size_t laser = 0;
  std::int32_t segment = 0;
  Place place = Place::kFree;
};
using Rows = std::vector<std::vector<Neighbour>>;

Rows CollectRows(const std::vector<LaserStripes>& stripes, const std::vector<std::vector<Place>>& places) {
  Rows rows;
  for (std::size_t k = 0; k < stripes.size(); ++k) {
    for (std::size_t i = 0; i < stripes[k].points.size(); ++i) {
      const StripePoint& p = stripes[k].points[i];
      const auto row = static_cast<std::size_t>(std::max(0.0F, p.v));
      if (row >= rows.size()) rows.resize(row + 1);
      if (places[k][i] != Place::kFree) rows[row].push_back({p.u, k, p.segment, places[k][i]});
    }
  }
  return rows;
}

// Are the stripes beside this point that lie on reference stripes as bright as those, rather than dimmer?
bool NeighboursAgree(const StripePoint& p, std::size_t laser, const Rows& rows,
                     const BackplaneStripeOptions& options) {
  const int row = static_cast<int>(p.v);
  const int last = std::min(static_cast<int>(rows.size()) - 1, row + options.vote_rows);
  int bright = 0, dim = 0;
  for (int r = std::max(0, row - options.vote_rows); r <= last; ++r) {
    for (const Neighbour& n : rows[static_cast<std::size_t>(r)]) {
      if ((n.laser == laser && n.segment == p.segment) || std::abs(n.u - p.u) > options.vote_columns_px)
        continue;
      ++(n.place == Place::kBackplane ? bright : dim);
    }
  }
  return bright >= dim;
}

// A stripe that lies on the backplane for the most part lies there with its dim ends and speckled rows too.
void CompleteSegments(const LaserStripes& stripes, const LaserGeometry& laser,
                      const BackplaneStripeOptions& options, std::vector<char>* backplane) {
  for (const StripeSegment& s : stripes.segments) {
    const auto begin = backplane->begin() + s.first;
    if (2 * std::count(begin, begin + s.count, 1) <= s.count) continue;
    for (std::int32_t i = s.first; i < s.first + s.count; ++i) {
      const auto index = static_cast<std::size_t>(i);
      if (NearestReference(laser, stripes.points[index], options.vote_distance_px) != nullptr)
        (*backplane)[index] = 1;
    }
  }
}

bool TouchesBackplane(const LaserStripes& stripes, const std::vector<char>& backplane,
                      const StripePoint& end) {
  constexpr float kRows = 4.0F, kColumns = 9.0F;
  for (std::size_t i = 0; i < backplane.size(); ++i) {
    const StripePoint& p = stripes.points[i];
    if (backplane[i] && std::abs(p.v - end.v) <= kRows && std::abs(p.u - end.u) <= kColumns) return true;
  }
  return false;
}

// Where the edge of the object's own shadow cuts a stripe on the backplane lengthwise, what is left of it is
// thin, dim and off the reference. Such a short piece continues a stripe on the backplane.
void CompleteRemnants(const LaserStripes& stripes, const LaserGeometry& laser,
                      const BackplaneStripeOptions& options, std::vector<char>* backplane) {
  const std::vector<char> before = *backplane;
  for (const StripeSegment& s : stripes.segments) {
    const std::int32_t last = s.first + s.count - 1;
    for (std::int32_t begin = s.first; begin <= last;) {
      std::int32_t end = begin;  // one past a run of points that are alike
      bool close = true;
      for (; end <= last && before[static_cast<std::size_t>(end)] == before[static_cast<std::size_t>(begin)];
           ++end) {
        const StripePoint& p = stripes.points[static_cast<std::size_t>(end)];
        close = close && NearestReference(laser, p, options.remnant_distance_px) != nullptr;
      }
      const bool candidate =
          !before[static_cast<std::size_t>(begin)] && close && end - begin <= options.remnant_rows;
      if (candidate &&
          (TouchesBackplane(stripes, before, stripes.points[static_cast<std::size_t>(begin)]) ||
           TouchesBackplane(stripes, before, stripes.points[static_cast<std::size_t>(end - 1)]))) {
        std::fill(backplane->begin() + begin, backplane->begin() + end, 1);
      }
      begin = end;
    }
  }
}

BackplaneSplit SplitOne(const LaserStripes& stripes, const std::vector<char>& backplane, int min_rows) {
  BackplaneSplit out;
  out.object.laser = stripes.laser;
  for (const StripeSegment& s : stripes.segments) {
    const auto first = static_cast<std::size_t>(s.first), count = static_cast<std::size_t>(s.count);
    const std::span<const StripePoint> points(stripes.points.data() + first, count);
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= count; ++i) {
      if (i < count && backplane[first + i] == backplane[first + begin]) continue;
      const auto piece = points.subspan(begin, i - begin);
      if (backplane[first + begin]) {
        out.backplane.insert(out.backplane.end(), piece.begin(), piece.end());
      } else if (piece.size() >= static_cast<std::size_t>(min_rows)) {
        AppendSegment(piece, std::nullopt, &out.object);
      }
      begin = i;
    }
  }
  return out;
}

}  // namespace

std::vector<BackplaneSplit> SplitBackplane(const std::vector<LaserStripes>& stripes,
                                           const DeviceGeometry& device, int min_rows,
                                           const BackplaneStripeOptions& options) {
  std::vector<std::vector<Place>> places;
  for (const LaserStripes& one : stripes) {
    std::vector<Place>& mine = places.emplace_back(one.points.size(), Place::kFree);
    const LaserGeometry* laser = device.FindLaser(one.laser);
    if (laser == nullptr) continue;
    for (const StripeSegment& s : one.segments) {
      const std::span<const StripePoint> points(one.points.data() + s.first,
                                                static_cast<std::size_t>(s.count));
      const std::vector<Place> found = FindPlaces(points, *laser, options);
      std::copy(found.begin(), found.end(), mine.begin() + s.first);
    }
  }
  const Rows rows = CollectRows(stripes, places);
  std::vector<BackplaneSplit> out;
  for (std::size_t k = 0; k < stripes.size(); ++k) {
    std::vector<char> backplane(stripes[k].points.size(), 0);
    for (std::size_t i = 0; i < backplane.size(); ++i) {
      backplane[i] =
          places[k][i] == Place::kBackplane && NeighboursAgree(stripes[k].points[i], k, rows, options) ? 1
                                                                                                       : 0;
    }
    if (const LaserGeometry* laser = device.FindLaser(stripes[k].laser)) {
      CompleteSegments(stripes[k], *laser, options, &backplane);
      CompleteRemnants(stripes[k], *laser, options, &backplane);
    }
    out.push_back(SplitOne(stripes[k], backplane, min_rows));
  }
  return out;
}

}  // namespace dorsum
