// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "geometry/mesh.h"

namespace dorsum {

// side x side vertices, `pitch` mm apart, about (0, 0); all diagonals run the same way.
inline TriangleMesh PlaneMesh(int side, double pitch, const std::function<double(double, double)>& height) {
  TriangleMesh mesh;
  const double middle = 0.5 * pitch * (side - 1);
  for (int r = 0; r < side; ++r) {
    for (int c = 0; c < side; ++c) {
      const double x = c * pitch - middle, y = r * pitch - middle;
      mesh.vertices.emplace_back(x, y, height(x, y));
    }
  }
  for (int r = 0; r + 1 < side; ++r) {
    for (int c = 0; c + 1 < side; ++c) {
      const auto i = static_cast<std::uint32_t>(r * side + c), n = static_cast<std::uint32_t>(side);
      mesh.faces.push_back({i, i + 1, i + n + 1});
      mesh.faces.push_back({i, i + n + 1, i + n});
    }
  }
  return mesh;
}

// A sphere about the origin, `rings` rings of 2 * rings vertices.
inline TriangleMesh SphereMesh(double radius, int rings) {
  TriangleMesh mesh;
  const int columns = 2 * rings;
  for (int r = 0; r <= rings; ++r) {
    const double polar = std::numbers::pi * r / rings;
    for (int c = 0; c < columns; ++c) {
      const double turn = 2.0 * std::numbers::pi * c / columns;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(turn),
                                 radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar));
    }
  }
  for (int r = 0; r < rings; ++r) {
    for (int c = 0; c < columns; ++c) {
      const auto at = [&](int row, int column) {
        return static_cast<std::uint32_t>(row * columns + column % columns);
      };
      mesh.faces.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
      mesh.faces.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
    }
  }
  return mesh;
}

}  // namespace dorsum
