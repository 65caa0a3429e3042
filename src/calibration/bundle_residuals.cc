// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_residuals.h"

#include <cmath>
#include <cstddef>

#include "calibration/stripe_models.h"

namespace dorsum {
namespace {

// How far the height of a point seen along the same ray moves when the sheet moves by 1 mm.
double HeightPerMm(const BundleCalibration& c, const SheetPoint& p, const Eigen::Vector3d& at) {
  const DiffractedFan& fan = *c.device.lasers[static_cast<std::size_t>(p.laser)].fan;
  const Eigen::Vector3d back = (c.device.camera.Center() - at).normalized();
  const auto here = Locate(fan, at), along = Locate(fan, at + back / back.z());  // 1 mm higher
  if (!here || !along) return 0.0;
  const double orders_per_height = std::abs(along->Order(fan) - here->Order(fan));
  return orders_per_height > 1e-9 ? p.orders_per_px / p.mm_per_px / orders_per_height : 0.0;
}

}  // namespace

std::vector<SheetResidual> Residuals(const BundleCalibration& c) {
  std::vector<SheetResidual> out;
  const StripeModels models(c.solution.state);
  for (const SheetPoint& p : c.data.points) {
    const StripeModel& model = models.Of(p.laser, p.plane);
    const Eigen::Vector2d pixel(p.u, p.v);
    const Eigen::Vector3d at = model.Place(pixel);
    SheetResidual r;
    r.laser = c.device.lasers[static_cast<std::size_t>(p.laser)].laser;
    r.order = p.order;
    r.picture = p.source;
    r.height_mm = c.data.planes[static_cast<std::size_t>(p.plane)].given_mm;
    r.x_mm = at.x();
    r.y_mm = at.y();
    r.miss_mm = (model.Order(pixel) - p.order) / p.orders_per_px * p.mm_per_px;
    r.sd_mm = p.sd_px * p.mm_per_px;
    r.height_per_mm = HeightPerMm(c, p, at);
    out.push_back(r);
  }
  return out;
}

std::vector<double> AssignedShares(const std::vector<SheetPicture>& pictures,
                                   const std::vector<SheetPoint>& points,
                                   const SheetAssignmentOptions& options) {
  std::vector<double> shares(pictures.size(), 0.0);
  for (const SheetPoint& p : points) shares[static_cast<std::size_t>(p.source)] += 1.0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    double all = 0.0;
    for (const StripeSegment& s : pictures[i].stripes.segments) {
      const int inner = s.count - 2 * options.end_rows;
      if (inner > 0) all += std::ceil(static_cast<double>(inner) / options.every_rows);
    }
    shares[i] = all > 0.0 ? shares[i] / all : 0.0;
  }
  return shares;
}

}  // namespace dorsum
