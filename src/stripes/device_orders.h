// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/calibration.h"
#include "stripes/ray_orders.h"

namespace dorsum {

// A device with what its pixels' rays meet of every laser's sheets, found once for a grid of pixels. In
// between, cubics give orders to 1e-4 and heights to a micrometre (tested), so that a scan need not solve for
// any pixel what depends on the calibration alone.
class DeviceOrders {
 public:
  explicit DeviceOrders(DeviceGeometry device);

  const DeviceGeometry& device() const { return device_; }

  // None where the pixel's ray does not meet the laser's sheets, or the device has no such laser. Heights
  // from kSlackMm below the working volume to as much above it. For as long as this object lives.
  std::optional<RayOrders> At(int laser, double u, double v) const;

  // The same, from the sheets themselves.
  std::optional<RayOrders> Exactly(const LaserGeometry& laser, double u, double v) const;

  static constexpr double kSlackMm = 3.0;

 private:
  struct Map {
    int laser = 0;
    std::vector<RayOrders::Orders> differences;  // by rows; NaN where the ray meets no sheet
  };

  DeviceGeometry device_;
  RayOrders::Nodes nodes_;
  double step_px_;
  int cols_, rows_;  // of the grid
  std::vector<Map> maps_;
};

}  // namespace dorsum
