// SPDX-License-Identifier: Apache-2.0
#include "stripes/device_orders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace dorsum {
namespace {

constexpr int kCells = 50;  // over the picture's width
constexpr int kFrame = 1;   // nodes around the picture that its first and last cells need

// Lagrange's weights of four neighbouring nodes at `t` of the way between the middle ones.
std::array<double, 4> CubicWeights(double t) {
  return {-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
          -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
}

int Nodes(int pixels, double step_px) {
  return static_cast<int>(std::ceil(pixels / step_px)) + 1 + 2 * kFrame;
}

// The first of the four nodes around x, in steps, and how far x is from the second.
std::pair<int, double> Around(double at, int nodes) {
  const int cell = std::clamp(static_cast<int>(std::floor(at)), 0, nodes - 2 - 2 * kFrame);
  return {cell, at - cell};
}

}  // namespace

DeviceOrders::DeviceOrders(DeviceGeometry device)
    : device_(std::move(device)),
      nodes_(device_.camera.Center().z(), device_.min_height_mm - kSlackMm, device_.max_height_mm + kSlackMm),
      step_px_(static_cast<double>(device_.camera.width) / kCells),
      cols_(Nodes(device_.camera.width, step_px_)),
      rows_(Nodes(device_.camera.height, step_px_)) {
  RayOrders::Orders nothing;
  nothing.fill(std::numeric_limits<double>::quiet_NaN());
  for (const LaserGeometry& laser : device_.lasers) {
    Map& map = maps_.emplace_back();
    map.laser = laser.laser;
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < cols_; ++c) {
        const auto orders =
            nodes_.Sample(device_.camera, laser, (c - kFrame) * step_px_, (r - kFrame) * step_px_);
        map.differences.push_back(orders ? nodes_.Differences(*orders) : nothing);
      }
    }
  }
}

std::optional<RayOrders> DeviceOrders::Exactly(const LaserGeometry& laser, double u, double v) const {
  const auto orders = nodes_.Sample(device_.camera, laser, u, v);
  if (!orders) return std::nullopt;
  return RayOrders(nodes_, nodes_.Differences(*orders));
}

std::optional<RayOrders> DeviceOrders::At(int laser, double u, double v) const {
  const auto map = std::find_if(maps_.begin(), maps_.end(), [&](const Map& m) { return m.laser == laser; });
  if (map == maps_.end()) return std::nullopt;
  const auto [c, tu] = Around(u / step_px_, cols_);
  const auto [r, tv] = Around(v / step_px_, rows_);
  const std::array<double, 4> wu = CubicWeights(tu), wv = CubicWeights(tv);
  RayOrders::Orders differences{};
  for (std::size_t y = 0; y < 4; ++y) {
    const auto* row = &map->differences[(static_cast<std::size_t>(r) + y) * static_cast<std::size_t>(cols_) +
                                        static_cast<std::size_t>(c)];
    for (std::size_t x = 0; x < 4; ++x) {
      const double weight = wv[y] * wu[x];
      for (std::size_t i = 0; i < differences.size(); ++i) differences[i] += weight * row[x][i];
    }
  }
  // A cell beside rays without a sheet is NaN throughout.
  if (std::isfinite(differences[0])) return RayOrders(nodes_, differences);
  return Exactly(*device_.FindLaser(laser), u, v);
}

}  // namespace dorsum
