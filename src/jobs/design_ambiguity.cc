// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_ambiguity.h"

#include <algorithm>
#include <cmath>

#include "jobs/design_point.h"

namespace dorsum {
namespace {

// One laser's order along one ray, at even steps of height.
struct OrderCurve {
  double low = 0.0, step = 1.0;
  std::vector<double> order;

  double Top() const { return low + step * static_cast<double>(order.size() - 1); }
  double At(double z) const {
    const double place = std::clamp((z - low) / step, 0.0, static_cast<double>(order.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(place), order.size() - 2);
    const double share = place - static_cast<double>(i);
    return order[i] + share * (order[i + 1] - order[i]);
  }
  // The height of this order; none outside the volume.
  std::optional<double> HeightOf(double wanted) const {
    const bool falls = order.back() < order.front();
    const double sign = falls ? -1.0 : 1.0;
    if (sign * wanted < sign * order.front() || sign * wanted > sign * order.back()) return std::nullopt;
    std::size_t i = 0, j = order.size() - 1;
    while (j - i > 1) {
      const std::size_t middle = (i + j) / 2;
      (sign * order[middle] <= sign * wanted ? i : j) = middle;
    }
    const double change = order[j] - order[i];
    return low + step * (static_cast<double>(i) + (change == 0.0 ? 0.0 : (wanted - order[i]) / change));
  }
  // Millimetres of height to an order, about z.
  double HeightPerOrder(double z) const {
    const double change = At(std::min(Top(), z + step)) - At(std::max(low, z - step));
    const double span = std::min(Top(), z + step) - std::max(low, z - step);
    return span / std::max(1e-12, std::abs(change));
  }
};

std::optional<OrderCurve> Follow(const DesignedDevice& device, const DesignedLaser& laser, const Ray& ray,
                                 double step_mm) {
  const auto& [low, high] = device.description.working_heights_mm;
  const int steps = std::max(1, static_cast<int>(std::ceil((high - low) / step_mm)));
  OrderCurve curve{low, (high - low) / steps, {}};
  for (int i = 0; i <= steps; ++i) {
    const auto order = OrderAlongRay(ray, laser, low + i * curve.step);
    if (!order) return std::nullopt;
    curve.order.push_back(*order);
  }
  return curve;
}

void JudgeSingle(const OrderCurve& curve, double* least, bool* beyond) {
  const double covered = std::abs(curve.order.back() - curve.order.front());
  const double volume = curve.Top() - curve.low;
  if (covered < 1.0) {
    if (*beyond) *least = std::min(*least, volume / std::max(covered, 1e-9));
    return;
  }
  if (*beyond) *least = volume;
  *beyond = false;
  const double up = curve.order.back() > curve.order.front() ? 1.0 : -1.0;
  for (std::size_t i = 0; i < curve.order.size(); ++i) {
    const double z = curve.low + curve.step * static_cast<double>(i);
    if (const auto next = curve.HeightOf(curve.order[i] + up)) *least = std::min(*least, *next - z);
    if (const auto last = curve.HeightOf(curve.order[i] - up)) *least = std::min(*least, z - *last);
  }
}

// False heights that the first laser offers for a true one, and how far the others' offers are from each.
void JudgeJoint(const std::vector<OrderCurve>& curves, double agreement_mm, HeightAmbiguity* out) {
  const OrderCurve& first = curves.front();
  const int most = static_cast<int>(std::abs(first.order.back() - first.order.front()));
  for (std::size_t i = 0; i < first.order.size(); ++i) {
    const double z = first.low + first.step * static_cast<double>(i);
    for (int shift = -most; shift <= most; ++shift) {
      if (shift == 0) continue;
      const auto offer = first.HeightOf(first.order[i] + shift);
      if (!offer) continue;
      double lowest = 0.0, highest = 0.0;
      for (std::size_t k = 1; k < curves.size(); ++k) {
        const double change = curves[k].At(*offer) - curves[k].order[i];
        const double up = curves[k].order.back() > curves[k].order.front() ? 1.0 : -1.0;
        const double off = up * (std::round(change) - change) * curves[k].HeightPerOrder(*offer);
        lowest = std::min(lowest, off);
        highest = std::max(highest, off);
      }
      const double spread = highest - lowest;
      out->joint_margin_mm = std::min(spread, out->joint_margin_mm.value_or(spread));
      if (spread > agreement_mm) continue;
      const double away = std::abs(*offer + 0.5 * (lowest + highest) - z);
      out->joint_mm = std::min(away, out->joint_mm.value_or(away));
    }
  }
}

}  // namespace

HeightAmbiguity FindAmbiguity(const DesignedDevice& device, const AmbiguityOptions& options) {
  const auto& [low, high] = device.description.working_heights_mm;
  HeightAmbiguity out;
  out.single_mm.assign(device.lasers.size(), 1e6);
  out.beyond_volume.assign(device.lasers.size(), true);
  const Eigen::Vector2d from = device.hand.min(), size = device.hand.sizes();
  for (int r = 0; r < options.rows; ++r) {
    for (int c = 0; c < options.columns; ++c) {
      const Eigen::Vector2d share((c + 0.5) / options.columns, (r + 0.5) / options.rows);
      const Eigen::Vector2d at = from + share.cwiseProduct(size);
      const Eigen::Vector3d middle(at.x(), at.y(), 0.5 * (low + high));
      const Eigen::Vector3d eye = device.camera.Center();
      const Ray ray{eye, (middle - eye).normalized()};
      std::vector<OrderCurve> curves;
      for (std::size_t k = 0; k < device.lasers.size(); ++k) {
        const auto curve = Follow(device, device.lasers[k], ray, options.height_step_mm);
        if (!curve) continue;
        bool beyond = out.beyond_volume[k];
        JudgeSingle(*curve, &out.single_mm[k], &beyond);
        out.beyond_volume[k] = beyond;
        curves.push_back(*curve);
      }
      if (curves.size() == device.lasers.size()) JudgeJoint(curves, options.agreement_mm, &out);
    }
  }
  return out;
}

}  // namespace dorsum
