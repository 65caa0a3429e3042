// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The straight line u(v) = at + slope (v - from) through some points, by least squares.
struct Line {
  double from = 0.0, at = 0.0, slope = 0.0;
  float At(float v) const { return static_cast<float>(at + slope * (static_cast<double>(v) - from)); }
};

Line LineThrough(const StripePoint* first, const StripePoint* last) {
  double n = 0.0, sv = 0.0, su = 0.0, svv = 0.0, suv = 0.0;
  for (const StripePoint* p = first; p != last; ++p) {
    const auto dv = static_cast<double>(p->v - first->v), u = static_cast<double>(p->u);
    n += 1.0;
    sv += dv;
    su += u;
    svv += dv * dv;
    suv += dv * u;
  }
  const double det = n * svv - sv * sv;
  const double slope = det > 1e-9 ? (n * suv - sv * su) / det : 0.0;
  return {static_cast<double>(first->v), (su - slope * sv) / n, slope};
}

// Where a piece begins; `hard` where the stripe itself breaks.
struct Cut {
  std::int32_t at = 0;
  bool hard = true;
};

// How far the lines through the points before and after point i miss each other, relative to what is allowed.
float Miss(const StripePoint* points, std::int32_t i, const JointPieceOptions& options) {
  const std::int32_t k = options.kink_rows;
  const float mid = 0.5F * (points[i].v + points[i - 1].v), reach = 0.5F * static_cast<float>(k);
  const Line before = LineThrough(points + i - k, points + i),
             after = LineThrough(points + i, points + i + k);
  const auto miss = [&](float v) { return std::abs(before.At(v) - after.At(v)); };
  return std::max(miss(mid) / options.step_px,
                  std::max(miss(mid - reach), miss(mid + reach)) / options.kink_px);
}

std::vector<Cut> FindCuts(const LaserStripes& stripes, const StripeSegment& segment,
                          const JointPieceOptions& options) {
  const StripePoint* points = stripes.points.data();
  const std::int32_t end = segment.first + segment.count, k = options.kink_rows;
  std::vector<Cut> cuts{{segment.first, true}};
  const auto broken = [&](std::int32_t i) {
    const float dv = points[i].v - points[i - 1].v, du = points[i].u - points[i - 1].u;
    return dv > static_cast<float>(options.max_gap_rows) + 0.5F ||
           std::abs(du) > options.max_jump_px * std::max(1.0F, dv);
  };
  const auto block = [&](std::int32_t i) {
    return static_cast<int>(std::floor(points[i].v)) / options.block_rows;
  };
  std::int32_t run = segment.first;  // where the unbroken part begins
  float worst = 1.0F;
  std::int32_t worst_at = -1;
  for (std::int32_t i = segment.first + 1; i < end; ++i) {
    const bool breaks = broken(i);
    const float miss = !breaks && i - run >= k && i + k <= end ? Miss(points, i, options) : 0.0F;
    if (miss > worst) {
      worst = miss;
      worst_at = i;
    }
    if (worst_at >= 0 && (breaks || miss <= 1.0F || i + 1 == end)) {
      cuts.push_back({worst_at, true});
      worst_at = -1;
      worst = 1.0F;
    }
    if (breaks) {
      cuts.push_back({i, true});
      run = i;
    }
  }
  cuts.push_back({end, true});
  // Blocks, unless that leaves crumbs.
  std::vector<Cut> all;
  for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
    all.push_back(cuts[c]);
    for (std::int32_t i = cuts[c].at + 1; i < cuts[c + 1].at; ++i) {
      if (block(i) != block(i - 1) && i - all.back().at >= k && cuts[c + 1].at - i >= k) {
        all.push_back({i, false});
      }
    }
  }
  all.push_back(cuts.back());
  return all;
}

struct OrderLimits {
  int first = 0, last = 0;
};

// The orders that can be seen within the working volume. Where the picture's border cuts the comb of the
// empty backplane, orders beyond those seen there come into view higher up.
OrderLimits OrdersInView(const DeviceOrders& orders, const LaserGeometry& laser) {
  const DeviceGeometry& device = orders.device();
  const Camera& camera = device.camera;
  OrderLimits limits{laser.min_order, laser.max_order};
  for (const double u : {0.0, camera.width - 1.0}) {
    const auto ray = orders.At(laser.laser, u, 0.5 * camera.height);
    if (!ray) continue;
    const double ground = ray->OrderAt(device.min_height_mm), top = ray->OrderAt(device.max_height_mm);
    if (ground < limits.first && ground > laser.min_order - 1.0) {
      limits.first = static_cast<int>(std::floor(std::min(ground, top)));
    }
    if (ground > limits.last && ground < laser.max_order + 1.0) {
      limits.last = static_cast<int>(std::ceil(std::max(ground, top)));
    }
  }
  return limits;
}

void FillHeights(const LaserStripes& stripes, const DeviceOrders& orders, const LaserGeometry& laser,
                 const JointPieceOptions& options, JointPiece* piece) {
  const DeviceGeometry& device = orders.device();
  const Eigen::Vector3d centre = device.camera.Center();
  const double low = device.min_height_mm - options.slack_mm, high = device.max_height_mm + options.slack_mm;
  std::vector<const StripePoint*> at;
  std::vector<RayOrders> rays;
  // Rows are those of a fixed comb, so that the pieces' samples meet; a shorter piece has its middle.
  for (std::int32_t i = piece->first; i < piece->first + piece->count; ++i) {
    const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
    const bool only = piece->count < options.sample_rows && i == piece->first + piece->count / 2;
    if (!only && (piece->count < options.sample_rows || std::lround(p.v) % options.sample_rows != 0)) {
      continue;
    }
    const auto ray = orders.At(laser.laser, static_cast<double>(p.u), static_cast<double>(p.v));
    if (!ray) continue;
    at.push_back(&p);
    rays.push_back(*ray);
  }
  if (rays.empty()) return;
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  double direction = 0.0;
  for (const RayOrders& ray : rays) {
    const double ground = ray.OrderAt(low), top = ray.OrderAt(high);
    first = std::min(first, static_cast<int>(std::ceil(std::min(ground, top))));
    last = std::max(last, static_cast<int>(std::floor(std::max(ground, top))));
    direction += top - ground;
  }
  const OrderLimits limits = OrdersInView(orders, laser);
  first = std::max(first, limits.first);
  last = std::min(last, limits.last);
  if (first > last) return;
  piece->step = direction > 0.0 ? 1 : -1;
  piece->lowest = direction > 0.0 ? first : last;
  piece->candidates = last - first + 1;
  piece->px_per_mm =
      static_cast<float>(device.camera.fx / (centre.z() - 0.25 * (low + 3.0 * device.min_height_mm + high)));
  piece->heights.reserve(rays.size() * static_cast<std::size_t>(piece->candidates));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    piece->samples.push_back({at[i]->u, at[i]->v});
    for (int k = 0; k < piece->candidates; ++k) {
      const double z = rays[i].HeightOf(piece->Order(k));
      piece->heights.push_back(z >= low && z <= high ? static_cast<float>(z) : kNan);
    }
  }
}

// Where a piece that lies on the backplane for a while leaves it, or comes to it: the index of the first
// sample behind; 0 where there is no such place.
std::size_t BackplaneEnd(const JointPiece& piece, const JointPieceOptions& options) {
  const auto n = piece.samples.size(), need = static_cast<std::size_t>(options.backplane_samples);
  for (std::size_t k = 0; k < static_cast<std::size_t>(piece.candidates); ++k) {
    const auto all = [&](std::size_t from, std::size_t to, bool near) {
      for (std::size_t i = from; i < to; ++i) {
        const float z = std::abs(piece.Heights(i)[k]);
        if (near ? !(z < options.backplane_mm) : !(z > 1.5F * options.backplane_mm)) return false;
      }
      return true;
    };
    for (std::size_t i = need; i + need <= n; ++i) {
      // One sample in between may be neither.
      if (all(i - need, i, true) &&
          (all(i, i + need, false) || (i + need < n && all(i + 1, i + 1 + need, false)))) {
        return i;
      }
      if (all(i, i + need, true) &&
          (all(i - need, i, false) || (i > need && all(i - 1 - need, i - 1, false)))) {
        return i;
      }
    }
  }
  return 0;
}

// Takes the part from sample `at` on off a piece, and returns it.
JointPiece SplitOff(const LaserStripes& stripes, std::size_t at, JointPiece* piece) {
  JointPiece rest = *piece;
  const float v = piece->samples[at].v;
  std::int32_t first = piece->first;
  while (stripes.points[static_cast<std::size_t>(first)].v < v - 0.5F) ++first;
  rest.first = first;
  rest.count = piece->first + piece->count - first;
  rest.follows = false;
  piece->count = first - piece->first;
  const auto middle = static_cast<std::ptrdiff_t>(at), middle_height = middle * piece->candidates;
  rest.samples.erase(rest.samples.begin(), rest.samples.begin() + middle);
  piece->samples.erase(piece->samples.begin() + middle, piece->samples.end());
  rest.heights.erase(rest.heights.begin(), rest.heights.begin() + middle_height);
  piece->heights.erase(piece->heights.begin() + middle_height, piece->heights.end());
  return rest;
}

}  // namespace

std::optional<int> JointPiece::Candidate(int order) const {
  const int k = (order - lowest) * step;
  if (k < 0 || k >= candidates) return std::nullopt;
  return k;
}

std::vector<JointPiece> CutPieces(const std::vector<LaserStripes>& stripes, const DeviceOrders& orders,
                                  const JointPieceOptions& options, const Context& context) {
  const DeviceGeometry& device = orders.device();
  std::vector<JointPiece> pieces;
  for (std::size_t l = 0; l < stripes.size(); ++l) {
    const std::vector<StripeSegment>& segments = stripes[l].segments;
    if (device.FindLaser(stripes[l].laser) == nullptr) continue;
    std::vector<std::vector<Cut>> all_cuts(segments.size());
    ParallelFor(context, 0, static_cast<std::int64_t>(segments.size()), [&](std::int64_t s) {
      const StripeSegment& segment = segments[static_cast<std::size_t>(s)];
      if (segment.count > 0) all_cuts[static_cast<std::size_t>(s)] = FindCuts(stripes[l], segment, options);
    });
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const std::vector<Cut>& cuts = all_cuts[s];
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        JointPiece piece;
        piece.laser = static_cast<int>(l);
        piece.segment = static_cast<std::int32_t>(s);
        piece.first = cuts[c].at;
        piece.count = cuts[c + 1].at - cuts[c].at;
        piece.follows = !cuts[c].hard;
        pieces.push_back(std::move(piece));
      }
    }
  }
  ParallelFor(context, 0, static_cast<std::int64_t>(pieces.size()), [&](std::int64_t i) {
    JointPiece& piece = pieces[static_cast<std::size_t>(i)];
    const LaserStripes& own = stripes[static_cast<std::size_t>(piece.laser)];
    FillHeights(own, orders, *device.FindLaser(own.laser), options, &piece);
  });
  std::vector<JointPiece> out;
  for (JointPiece& piece : pieces) {
    const LaserStripes& own = stripes[static_cast<std::size_t>(piece.laser)];
    for (std::size_t at = BackplaneEnd(piece, options); at != 0; at = BackplaneEnd(piece, options)) {
      JointPiece rest = SplitOff(own, at, &piece);
      out.push_back(std::exchange(piece, std::move(rest)));
    }
    out.push_back(std::move(piece));
  }
  return out;
}

}  // namespace dorsum
