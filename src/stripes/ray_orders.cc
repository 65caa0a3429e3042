// SPDX-License-Identifier: Apache-2.0
#include "stripes/ray_orders.h"

#include <cmath>

namespace dorsum {

RayOrders::RayOrders(const Camera& camera, const LaserGeometry& laser, double u, double v, double low_mm,
                     double high_mm)
    : camera_height_(camera.Center().z()) {
  const SheetModel model = laser.fan ? SheetModel::kCone : SheetModel::kPlane;
  const std::array<double, 3> heights = {low_mm, 0.5 * (low_mm + high_mm), high_mm};
  const Ray ray = CastRay(camera, {u, v});
  for (std::size_t i = 0; i < 3; ++i) {
    const auto order = OrderAtHeight(ray, laser, model, heights[i]);
    if (!order) return;
    order_[i] = *order;
    w_[i] = 1.0 / (camera_height_ - heights[i]);
  }
  slope_ = (order_[1] - order_[0]) / (w_[1] - w_[0]);
  curve_ = ((order_[2] - order_[1]) / (w_[2] - w_[1]) - slope_) / (w_[2] - w_[0]);
  valid_ = std::isfinite(slope_) && std::isfinite(curve_) && slope_ != 0.0;
}

double RayOrders::HeightOf(double order) const {
  double w = w_[0] + (order - order_[0]) / slope_;
  for (int i = 0; i < 3; ++i) {
    const double value = order_[0] + (w - w_[0]) * (slope_ + curve_ * (w - w_[1])) - order;
    w -= value / (slope_ + curve_ * (2.0 * w - w_[0] - w_[1]));
  }
  return camera_height_ - 1.0 / w;
}

}  // namespace dorsum
