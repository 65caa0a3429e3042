// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_height.h"

#include <algorithm>
#include <cmath>

namespace dorsum {

std::int64_t MeshHeight::Cell(double value, double origin) const {
  return static_cast<std::int64_t>(std::floor((value - origin) / cell_mm_));
}

MeshHeight::MeshHeight(const TriangleMesh& mesh, double cell_mm) : mesh_(mesh), cell_mm_(cell_mm) {
  if (mesh.faces.empty()) return;
  Eigen::Vector3d low = mesh.vertices.front(), high = low;
  for (const auto& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  // A mesh of kilometres would ask for endless cells; larger ones serve it as well.
  cell_mm_ = std::max(cell_mm_, (high - low).head<2>().maxCoeff() / 2000.0);
  x0_ = low.x();
  y0_ = low.y();
  columns_ = Cell(high.x(), x0_) + 1;
  rows_ = Cell(high.y(), y0_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_ * rows_));
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    Eigen::Vector3d a = mesh.vertices[mesh.faces[f][0]], b = a;
    for (const std::uint32_t i : mesh.faces[f]) {
      a = a.cwiseMin(mesh.vertices[i]);
      b = b.cwiseMax(mesh.vertices[i]);
    }
    for (std::int64_t r = Cell(a.y(), y0_); r <= Cell(b.y(), y0_); ++r) {
      for (std::int64_t c = Cell(a.x(), x0_); c <= Cell(b.x(), x0_); ++c) {
        cells_[static_cast<std::size_t>(r * columns_ + c)].push_back(f);
      }
    }
  }
}

std::optional<double> MeshHeight::At(double x, double y) const {
  const std::int64_t c = Cell(x, x0_), r = Cell(y, y0_);
  if (c < 0 || r < 0 || c >= columns_ || r >= rows_) return std::nullopt;
  std::optional<double> highest;
  for (const std::uint32_t f : cells_[static_cast<std::size_t>(r * columns_ + c)]) {
    const auto& face = mesh_.faces[f];
    const Eigen::Vector3d &p = mesh_.vertices[face[0]], &q = mesh_.vertices[face[1]],
                          &s = mesh_.vertices[face[2]];
    const double det = (q.x() - p.x()) * (s.y() - p.y()) - (s.x() - p.x()) * (q.y() - p.y());
    if (std::abs(det) < 1e-15) continue;  // seen edge-on from above
    const double b = ((x - p.x()) * (s.y() - p.y()) - (s.x() - p.x()) * (y - p.y())) / det;
    const double g = ((q.x() - p.x()) * (y - p.y()) - (x - p.x()) * (q.y() - p.y())) / det;
    constexpr double kEdge = -1e-9;  // so that no point falls between two triangles
    if (b < kEdge || g < kEdge || b + g > 1.0 - kEdge) continue;
    const double z = p.z() + b * (q.z() - p.z()) + g * (s.z() - p.z());
    if (!highest || z > *highest) highest = z;
  }
  return highest;
}

}  // namespace dorsum
