// SPDX-License-Identifier: Apache-2.0
#include "surface/triangulation.h"

#include <cmath>
#include <optional>

#include "base/parallel.h"

namespace dorsum {
namespace {

enum class Outcome { kPoint, kNoOrder, kNoSheet };

// Where a pixel's ray meets the sheet of an order, and how its height grows with the column.
struct Meeting {
  Eigen::Vector3d position;
  double dz_du = 0.0;
};

std::optional<Meeting> MeetCone(const StripePoint& p, int order, const DeviceOrders& orders,
                                const LaserGeometry& laser) {
  if (!laser.fan) return std::nullopt;
  const auto u = static_cast<double>(p.u), v = static_cast<double>(p.v);
  const auto here = orders.At(laser.laser, u, v), beside = orders.At(laser.laser, u + 0.5, v);
  if (!here || !beside) return std::nullopt;
  const double z = here->HeightOf(order);
  const Ray ray = CastRay(orders.device().camera, {u, v});
  return Meeting{ray.At((z - ray.origin.z()) / ray.direction.z()), 2.0 * (beside->HeightOf(order) - z)};
}

std::optional<Meeting> MeetPlane(const StripePoint& p, int order, const Camera& camera,
                                 const LaserGeometry& laser) {
  const auto here = IntersectSheet(CastRay(camera, {p.u, p.v}), laser, SheetModel::kPlane, order);
  const auto beside = IntersectSheet(CastRay(camera, {p.u + 0.5, p.v}), laser, SheetModel::kPlane, order);
  if (!here || !beside) return std::nullopt;
  return Meeting{*here, 2.0 * (beside->z() - here->z())};
}

std::optional<SurfacePoint> TriangulateOne(const StripePoint& p, int order, const DeviceOrders& orders,
                                           const LaserGeometry& laser, const TriangulationOptions& options) {
  const bool plane = options.sheets == SheetModel::kPlane;
  const auto met =
      plane ? MeetPlane(p, order, orders.device().camera, laser) : MeetCone(p, order, orders, laser);
  if (!met || !met->position.allFinite()) return std::nullopt;
  SurfacePoint out;
  out.position = met->position;
  if (options.correction && plane) {
    const Ray ray = CastRay(orders.device().camera, {p.u, p.v});
    const double z = laser.correction.CorrectedZ(met->position.x(), met->position.z());
    out.position = ray.At((z - ray.origin.z()) / ray.direction.z());
  }
  const double dz_du = met->dz_du;
  out.sigma = static_cast<float>(std::hypot(dz_du * p.sd_px, laser.residual_mm));
  if (p.row_sd_px > 0.0F) {
    out.row_z = static_cast<float>(out.position.z() + dz_du * static_cast<double>(p.row_u - p.u));
    out.row_sigma =
        static_cast<float>(std::hypot(dz_du * static_cast<double>(p.row_sd_px), laser.residual_mm));
  }
  out.laser = static_cast<std::uint8_t>(laser.laser);
  out.order = static_cast<std::int16_t>(order);
  out.u = p.u;
  out.v = p.v;
  out.segment = p.segment;
  return out;
}

std::size_t PointsWithOrder(const IndexedStripes& stripes) {
  std::size_t count = 0;
  for (const LaserStripes& one : stripes.lasers) {
    for (const StripeSegment& segment : one.segments) {
      if (segment.order) count += static_cast<std::size_t>(segment.count);
    }
  }
  return count;
}

}  // namespace

Triangulation Triangulate(const IndexedStripes& stripes, const DeviceOrders& orders,
                          const TriangulationOptions& options, const Context& context) {
  Triangulation out;
  out.points.reserve(PointsWithOrder(stripes));
  for (const LaserStripes& one : stripes.lasers) {
    const LaserGeometry* laser = orders.device().FindLaser(one.laser);
    if (laser == nullptr) continue;
    std::vector<std::optional<SurfacePoint>> points(one.points.size());
    std::vector<Outcome> outcomes(one.points.size(), Outcome::kNoOrder);
    ParallelFor(context, 0, static_cast<std::int64_t>(one.segments.size()), [&](std::int64_t s) {
      const StripeSegment& segment = one.segments[static_cast<std::size_t>(s)];
      if (!segment.order) return;
      for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        points[index] = TriangulateOne(one.points[index], *segment.order, orders, *laser, options);
        outcomes[index] = points[index] ? Outcome::kPoint : Outcome::kNoSheet;
      }
    });
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i]) out.points.push_back(*points[i]);
      out.without_order += outcomes[i] == Outcome::kNoOrder ? 1 : 0;
      out.without_sheet += outcomes[i] == Outcome::kNoSheet ? 1 : 0;
    }
  }
  return out;
}

}  // namespace dorsum
