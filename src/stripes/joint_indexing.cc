// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_indexing.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel.h"

namespace dorsum {
namespace {

// Segment of the points [first, first + count), with its extremes.
StripeSegment Summarise(const std::vector<StripePoint>& points, std::int32_t first, std::int32_t count,
                        std::optional<int> order) {
  StripeSegment s;
  s.first = first;
  s.count = count;
  s.order = order;
  const StripePoint& p0 = points[static_cast<std::size_t>(first)];
  s.min_u = s.max_u = p0.u;
  s.min_v = s.max_v = p0.v;
  double sum = 0.0;
  for (std::int32_t i = first; i < first + count; ++i) {
    const StripePoint& p = points[static_cast<std::size_t>(i)];
    s.min_u = std::min(s.min_u, p.u);
    s.max_u = std::max(s.max_u, p.u);
    s.min_v = std::min(s.min_v, p.v);
    s.max_v = std::max(s.max_v, p.v);
    sum += p.peak;
  }
  s.mean_peak = static_cast<float>(sum / count);
  return s;
}

// Replaces a laser's segments by its pieces; those of one segment that follow each other with one order stay
// together.
void ReplaceSegments(const std::vector<JointPiece>& pieces, const std::vector<std::optional<int>>& orders,
                     int index, LaserStripes* stripes) {
  struct Part {
    std::int32_t segment, first, count;
    std::optional<int> order;
  };
  std::vector<Part> parts;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const JointPiece& p = pieces[i];
    if (p.laser != index) continue;
    if (!parts.empty() && parts.back().segment == p.segment && parts.back().order == orders[i]) {
      parts.back().count += p.count;
    } else {
      parts.push_back({p.segment, p.first, p.count, orders[i]});
    }
  }
  stripes->segments.clear();
  for (const Part& part : parts) {
    const auto own = static_cast<std::int32_t>(stripes->segments.size());
    stripes->segments.push_back(Summarise(stripes->points, part.first, part.count, part.order));
    for (std::int32_t i = part.first; i < part.first + part.count; ++i) {
      stripes->points[static_cast<std::size_t>(i)].segment = own;
    }
  }
  const auto same = [&](std::int32_t a, std::int32_t b) {
    return stripes->points[static_cast<std::size_t>(a)].segment ==
           stripes->points[static_cast<std::size_t>(b)].segment;
  };
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(stripes->points.size()); ++i) {
    StripePoint& p = stripes->points[static_cast<std::size_t>(i)];
    if (p.top != kNoPoint && !same(i, p.top)) p.top = kNoPoint;
    if (p.bottom != kNoPoint && !same(i, p.bottom)) p.bottom = kNoPoint;
  }
}

}  // namespace

IndexedStripes IndexJointly(std::vector<LaserStripes> stripes, const DeviceOrders& device_orders,
                            const JointIndexingOptions& options, const Context& context,
                            const std::function<void()>& meanwhile) {
  const DeviceGeometry& device = device_orders.device();
  std::erase_if(stripes, [&](const LaserStripes& s) { return device.FindLaser(s.laser) == nullptr; });
  const std::vector<JointPiece> pieces = CutPieces(stripes, device_orders, options.pieces, context);
  const JointGraph graph = BuildJointGraph(pieces, options.pieces.sample_rows, device.min_height_mm,
                                           device.max_height_mm, options.graph, context);
  JointLabels labels;
  ParallelFor(context, 0, meanwhile ? 2 : 1, [&](std::int64_t task) {
    if (task == 0) labels = InferLabels(pieces, graph, options.inference, context);
    if (task == 1) meanwhile();
  });
  std::vector<std::optional<int>> orders(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (labels.candidate[i] < 0 || labels.own_margin[i] < options.min_own_margin ||
        labels.surface_margin[i] < options.min_surface_margin) {
      continue;
    }
    orders[i] = pieces[i].Order(labels.candidate[i]);
  }
  IndexedStripes out;
  for (std::size_t l = 0; l < stripes.size(); ++l) {
    ReplaceSegments(pieces, orders, static_cast<int>(l), &stripes[l]);
    IndexingDiagnostics d;
    d.laser = stripes[l].laser;
    d.segments = static_cast<int>(stripes[l].segments.size());
    d.left_out = static_cast<int>(std::count_if(stripes[l].segments.begin(), stripes[l].segments.end(),
                                                [](const StripeSegment& s) { return !s.order; }));
    out.diagnostics.push_back(d);
    out.lasers.push_back(std::move(stripes[l]));
  }
  return out;
}

}  // namespace dorsum
