// SPDX-License-Identifier: Apache-2.0
#include "simulator/sheet_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dorsum {
namespace {

// The pixel column at which a camera's row sees the sheet of an order at height z, by Newton's method.
std::optional<double> ColumnAt(const Camera& camera, const LaserGeometry& laser, int order, double v,
                               double z, double u) {
  for (int i = 0; i < 30; ++i) {
    const auto here = OrderAtHeight(camera, laser, SheetModel::kCone, {u, v}, z);
    const auto there = OrderAtHeight(camera, laser, SheetModel::kCone, {u + 0.01, v}, z);
    if (!here || !there || *here == *there) return std::nullopt;
    const double change = std::clamp((*here - order) / ((*there - *here) / 0.01), -400.0, 400.0);
    u -= change;
    if (std::abs(change) < 1e-9) {
      const bool inside = u >= 0.0 && u <= camera.width - 1;
      return inside ? std::optional(u) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<SheetError> MeasureSheetError(const DeviceGeometry& device, const Camera& true_camera,
                                          const std::vector<DiffractedFan>& true_fans,
                                          const std::vector<int>& true_orders,
                                          const SheetErrorOptions& options) {
  std::vector<SheetError> errors;
  for (const LaserGeometry& laser : device.lasers) {
    const auto k = static_cast<std::size_t>(laser.laser);
    if (k >= true_fans.size()) continue;
    LaserGeometry truth;
    truth.fan = true_fans[k];
    SheetError e;
    e.laser = laser.laser;
    for (double z = options.min_height_mm; z <= options.max_height_mm + 1e-9; z += options.height_step_mm) {
      for (double v = 0.0; v <= true_camera.height - 1; v += options.row_step_px) {
        for (int m = -true_orders[k]; m <= true_orders[k]; ++m) {
          const auto u = ColumnAt(true_camera, truth, m, v, z, 0.5 * true_camera.width);
          if (!u) continue;
          const auto at = IntersectSheet(CastRay(device.camera, {*u, v}), laser, SheetModel::kCone, m);
          if (!at) {
            ++e.lost;
            continue;
          }
          const double miss = at->z() - z;
          e.rms_mm += miss * miss;
          e.mean_mm += miss;
          e.worst_mm = std::max(e.worst_mm, std::abs(miss));
          ++e.points;
        }
      }
    }
    if (e.points > 0) {
      e.rms_mm = std::sqrt(e.rms_mm / static_cast<double>(e.points));
      e.mean_mm /= static_cast<double>(e.points);
    }
    errors.push_back(e);
  }
  return errors;
}

std::vector<SheetError> MeasureSheetError(const DeviceGeometry& device, const VirtualDevice& truth,
                                          const SheetErrorOptions& options) {
  std::vector<DiffractedFan> fans;
  std::vector<int> orders;
  for (const VirtualLaser& laser : truth.lasers) {
    fans.push_back(laser.fan);
    orders.push_back(laser.Orders());
  }
  return MeasureSheetError(device, truth.camera, fans, orders, options);
}

}  // namespace dorsum
