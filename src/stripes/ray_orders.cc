// SPDX-License-Identifier: Apache-2.0
#include "stripes/ray_orders.h"

namespace dorsum {
namespace {

double HeightAt(std::size_t i, double low_mm, double high_mm) {
  return low_mm + (high_mm - low_mm) * static_cast<double>(i) / (RayOrders::kHeights - 1.0);
}

}  // namespace

std::optional<RayOrders::Orders> RayOrders::Sample(const Camera& camera, const LaserGeometry& laser, double u,
                                                   double v, double low_mm, double high_mm) {
  const SheetModel model = laser.fan ? SheetModel::kCone : SheetModel::kPlane;
  const Ray ray = CastRay(camera, {u, v});
  Orders orders{};
  for (std::size_t i = 0; i < kHeights; ++i) {
    const auto order = OrderAtHeight(ray, laser, model, HeightAt(i, low_mm, high_mm));
    if (!order) return std::nullopt;
    orders[i] = *order;
  }
  return orders;
}

RayOrders::RayOrders(double camera_height_mm, double low_mm, double high_mm, const Orders& orders)
    : camera_height_(camera_height_mm), w_(), coefficients_(orders) {
  for (std::size_t i = 0; i < kHeights; ++i) w_[i] = 1.0 / (camera_height_ - HeightAt(i, low_mm, high_mm));
  for (std::size_t k = 1; k < kHeights; ++k) {  // divided differences
    for (std::size_t i = kHeights - 1; i >= k; --i) {
      coefficients_[i] = (coefficients_[i] - coefficients_[i - 1]) / (w_[i] - w_[i - k]);
    }
  }
}

double RayOrders::OrderAt(double height_mm) const {
  const double w = 1.0 / (camera_height_ - height_mm);
  double value = coefficients_[kHeights - 1];
  for (std::size_t i = kHeights - 1; i-- > 0;) value = value * (w - w_[i]) + coefficients_[i];
  return value;
}

double RayOrders::HeightOf(double order) const {
  double w = w_[0] + (order - coefficients_[0]) / coefficients_[1];
  constexpr int kSteps = 3;  // of Newton's method, from the chord; the curve is nearly straight
  for (int step = 0; step < kSteps; ++step) {
    double value = coefficients_[kHeights - 1], slope = 0.0;
    for (std::size_t i = kHeights - 1; i-- > 0;) {
      slope = slope * (w - w_[i]) + value;
      value = value * (w - w_[i]) + coefficients_[i];
    }
    w -= (value - order) / slope;
  }
  return camera_height_ - 1.0 / w;
}

}  // namespace dorsum
