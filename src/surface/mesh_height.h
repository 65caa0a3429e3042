// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh.h"

namespace dorsum {

// Answers how high a mesh is at a place of the backplane, quickly: triangles are sorted into square cells.
// Keeps a reference to the mesh, which must outlive it.
class MeshHeight {
 public:
  explicit MeshHeight(const TriangleMesh& mesh, double cell_mm = 2.0);

  // Greatest z of the mesh above or below (x, y), mm; none where there is no triangle.
  std::optional<double> At(double x, double y) const;

 private:
  std::int64_t Cell(double value, double origin) const;
  const TriangleMesh& mesh_;
  double cell_mm_ = 2.0, x0_ = 0.0, y0_ = 0.0;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace dorsum
