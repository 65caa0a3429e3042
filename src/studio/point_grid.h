// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "surface/surface_point.h"

namespace dorsum {

// Surface points sorted into square cells of the backplane, for what is near. Keeps a reference to the
// points, which must outlive it; points that are not finite are left out.
class PointGrid {
 public:
  PointGrid(const SurfacePoints& points, double cell_mm) : points_(points), cell_mm_(cell_mm) {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (points[i].position.allFinite())
        cells_[Key(points[i].position.x(), points[i].position.y())].push_back(i);
    }
  }

  // Calls f(index) for all points within a cell's width of (x, y), and some more.
  template <class F>
  void ForNear(double x, double y, F f) const {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const auto cell = cells_.find(Key(x + dx * cell_mm_, y + dy * cell_mm_));
        if (cell == cells_.end()) continue;
        for (const std::uint32_t i : cell->second) f(i);
      }
    }
  }

  // The nearest in space, if it is no further than a cell's width.
  std::optional<std::uint32_t> Nearest(const Eigen::Vector3d& p) const {
    std::optional<std::uint32_t> best;
    double least = cell_mm_ * cell_mm_;
    ForNear(p.x(), p.y(), [&](std::uint32_t i) {
      const double d = (points_[i].position - p).squaredNorm();
      if (d > least) return;
      least = d;
      best = i;
    });
    return best;
  }

 private:
  std::uint64_t Key(double x, double y) const {
    const auto cell = [&](double v) {
      return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(v / cell_mm_)));
    };
    return (static_cast<std::uint64_t>(cell(x)) << 32) | cell(y);
  }
  const SurfacePoints& points_;
  double cell_mm_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace dorsum
