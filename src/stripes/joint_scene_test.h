// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/calibration.h"
#include "stripes/stripe_layout_test.h"

namespace dorsum {

// A small device with cone sheets whose orders are worth about 33 mm of height, and a flat table before it.
inline DeviceGeometry FanDevice(int lasers) {
  DeviceGeometry device;
  Camera& camera = device.camera;
  camera.width = 800;
  camera.height = 600;
  camera.fx = camera.fy = 1000.0;
  camera.cx = 400.0;
  camera.cy = 300.0;
  // At (-130, 0, 400), looking at the origin.
  const double c = 400.0 / std::hypot(400.0, 130.0), s = 130.0 / std::hypot(400.0, 130.0);
  camera.camera_from_world.rotation << c, 0.0, s, 0.0, -1.0, 0.0, s, 0.0, -c;
  camera.camera_from_world.translation =
      -(camera.camera_from_world.rotation * Eigen::Vector3d(-130.0, 0.0, 400.0));
  for (int k = 0; k < lasers; ++k) {
    LaserGeometry laser;
    laser.laser = k;
    laser.min_order = -20;
    laser.max_order = 20;
    DiffractedFan fan;
    fan.origin = {16.2 * k, 0.0, 410.0};
    fan.fan_distance_mm = 12.0;
    fan.step = 0.0263;
    laser.fan = fan;
    laser.grating = fan.origin;
    device.lasers.push_back(laser);
  }
  return device;
}

// A table of height `height_mm` above the world's rectangle |x| < 60, |y| < 40.
struct Table {
  double height_mm = 40.0;
  static bool Contains(const Eigen::Vector3d& p) { return std::abs(p.x()) < 60.0 && std::abs(p.y()) < 40.0; }
};

inline Eigen::Vector3d PointAt(const Camera& camera, double u, double v, double z) {
  const Ray ray = CastRay(camera, {u, v});
  return ray.At((z - ray.origin.z()) / ray.direction.z());
}

// Column at which a laser's order shows in a row if the surface has height z; by Newton's method.
inline std::optional<double> ColumnOf(const DeviceGeometry& device, const LaserGeometry& laser, int order,
                                      double v, double z) {
  double u = device.camera.cx;
  for (int i = 0; i < 20; ++i) {
    const auto here = OrderAtHeight(device.camera, laser, SheetModel::kCone, {u, v}, z);
    const auto there = OrderAtHeight(device.camera, laser, SheetModel::kCone, {u + 0.5, v}, z);
    if (!here || !there) return std::nullopt;
    const double change = (order - *here) / (2.0 * (*there - *here));
    u += change;
    if (std::abs(change) < 1e-9) break;
  }
  if (u < 0.0 || u > device.camera.width - 1.0) return std::nullopt;
  return u;
}

struct TrueStripes {
  LaserStripes stripes;
  std::vector<int> orders;      // by segment
  std::vector<double> heights;  // by segment
};

// What a laser draws on the table and, where wanted, on the backplane beside it.
inline TrueStripes DrawTable(const DeviceGeometry& device, int k, const Table& table, bool with_backplane) {
  TrueStripes out;
  out.stripes.laser = k;
  const LaserGeometry& laser = *device.FindLaser(k);
  for (int m = laser.min_order; m <= laser.max_order; ++m) {
    for (const double z : {table.height_mm, 0.0}) {
      if (z == 0.0 && !with_backplane) continue;
      int from = -1;
      const auto seen = [&](int v) {
        const auto u = ColumnOf(device, laser, m, v, z);
        if (!u) return false;
        const bool covered = Table::Contains(PointAt(device.camera, *u, v, table.height_mm));
        return z > 0.0 ? covered : !covered && !Table::Contains(PointAt(device.camera, *u, v, 0.0));
      };
      for (int v = 0; v <= device.camera.height; ++v) {
        const bool here = v < device.camera.height && seen(v);
        if (here && from < 0) from = v;
        if (here || from < 0) continue;
        if (v - from >= 6) {
          AddStripe(&out.stripes, from, v, [&](int row) { return *ColumnOf(device, laser, m, row, z); });
          out.orders.push_back(m);
          out.heights.push_back(z);
        }
        from = -1;
      }
    }
  }
  return out;
}

}  // namespace dorsum
