// SPDX-License-Identifier: Apache-2.0
#include "stripes/ray_orders.h"

namespace dorsum {

RayOrders::Nodes::Nodes(double camera_height_mm, double low_mm, double high_mm)
    : camera_height_(camera_height_mm) {
  for (std::size_t i = 0; i < kHeights; ++i) {
    heights_[i] = low_mm + (high_mm - low_mm) * static_cast<double>(i) / (kHeights - 1.0);
    w_[i] = W(heights_[i]);
  }
}

std::optional<RayOrders::Orders> RayOrders::Nodes::Sample(const Camera& camera, const LaserGeometry& laser,
                                                          double u, double v) const {
  const SheetModel model = laser.fan ? SheetModel::kCone : SheetModel::kPlane;
  const Ray ray = CastRay(camera, {u, v});
  Orders orders{};
  for (std::size_t i = 0; i < kHeights; ++i) {
    const auto order = OrderAtHeight(ray, laser, model, heights_[i]);
    if (!order) return std::nullopt;
    orders[i] = *order;
  }
  return orders;
}

RayOrders::Orders RayOrders::Nodes::Differences(const Orders& orders) const {
  Orders out = orders;
  for (std::size_t k = 1; k < kHeights; ++k) {
    for (std::size_t i = kHeights - 1; i >= k; --i) out[i] = (out[i] - out[i - 1]) / (w_[i] - w_[i - k]);
  }
  return out;
}

double RayOrders::OrderAt(double height_mm) const {
  const double w = nodes_->W(height_mm);
  double value = coefficients_[kHeights - 1];
  for (std::size_t i = kHeights - 1; i-- > 0;) value = value * (w - nodes_->w(i)) + coefficients_[i];
  return value;
}

double RayOrders::HeightOf(double order) const {
  double w = nodes_->w(0) + (order - coefficients_[0]) / coefficients_[1];
  constexpr int kSteps = 3;  // of Newton's method, from the chord; the curve is nearly straight
  for (int step = 0; step < kSteps; ++step) {
    double value = coefficients_[kHeights - 1], slope = 0.0;
    for (std::size_t i = kHeights - 1; i-- > 0;) {
      slope = slope * (w - nodes_->w(i)) + value;
      value = value * (w - nodes_->w(i)) + coefficients_[i];
    }
    w -= (value - order) / slope;
  }
  return nodes_->HeightAt(w);
}

}  // namespace dorsum
