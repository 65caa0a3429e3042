// SPDX-License-Identifier: Apache-2.0
#include "surface/triangulation.h"

#include <cmath>
#include <optional>

#include "base/parallel.h"

namespace dorsum {
namespace {

enum class Outcome { kPoint, kNoOrder, kNoSheet };

std::optional<SurfacePoint> TriangulateOne(const StripePoint& p, int order, const DeviceGeometry& device,
                                           const LaserGeometry& laser, const TriangulationOptions& options) {
  const Ray ray = CastRay(device.camera, {p.u, p.v});
  const auto position = IntersectSheet(ray, laser, options.sheets, order);
  if (!position || !position->allFinite()) return std::nullopt;
  // Half a pixel to the side, for the derivative of z by u.
  const auto beside =
      IntersectSheet(CastRay(device.camera, {p.u + 0.5, p.v}), laser, options.sheets, order, position->z());
  if (!beside) return std::nullopt;
  SurfacePoint out;
  out.position = *position;
  if (options.correction && options.sheets == SheetModel::kPlane) {
    const double z = laser.correction.CorrectedZ(position->x(), position->z());
    out.position = ray.At((z - ray.origin.z()) / ray.direction.z());
  }
  const double dz_du = 2.0 * (beside->z() - position->z());
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

}  // namespace

Triangulation Triangulate(const IndexedStripes& stripes, const DeviceGeometry& device,
                          const TriangulationOptions& options, const Context& context) {
  Triangulation out;
  for (const LaserStripes& one : stripes.lasers) {
    const LaserGeometry* laser = device.FindLaser(one.laser);
    if (laser == nullptr) continue;
    std::vector<std::optional<SurfacePoint>> points(one.points.size());
    std::vector<Outcome> outcomes(one.points.size(), Outcome::kNoOrder);
    ParallelFor(context, 0, static_cast<std::int64_t>(one.segments.size()), [&](std::int64_t s) {
      const StripeSegment& segment = one.segments[static_cast<std::size_t>(s)];
      if (!segment.order) return;
      for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        points[index] = TriangulateOne(one.points[index], *segment.order, device, *laser, options);
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
