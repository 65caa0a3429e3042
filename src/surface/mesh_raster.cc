// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "base/parallel.h"

namespace dorsum {
namespace {

// Raises heights to those of the faces `first` to `end` - 1.
void DrawFaces(const TriangleMesh& mesh, std::size_t first, std::size_t end, const HeightField& field,
               cv::Mat1f* heights) {
  for (std::size_t k = first; k < end; ++k) {
    const auto& f = mesh.faces[k];
    std::array<Eigen::Vector2d, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = (mesh.vertices[f[i]].head<2>() - field.origin_mm) / field.pitch_mm;
    const auto [c0, c1] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [r0, r1] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    const int left = static_cast<int>(std::ceil(c0)), right = static_cast<int>(std::floor(c1));
    const int top = static_cast<int>(std::ceil(r0)), bottom = static_cast<int>(std::floor(r1));
    if (left > right || top > bottom) continue;
    const Eigen::Vector2d e1 = p[1] - p[0], e2 = p[2] - p[0];
    const double area = e1.x() * e2.y() - e1.y() * e2.x();
    if (std::abs(area) < 1e-12) continue;
    for (int r = top; r <= bottom; ++r) {
      for (int c = left; c <= right; ++c) {
        const Eigen::Vector2d q(c - p[0].x(), r - p[0].y());
        const double s = (q.x() * e2.y() - q.y() * e2.x()) / area,
                     t = (e1.x() * q.y() - e1.y() * q.x()) / area;
        constexpr double kSlack = 1e-9;
        if (s < -kSlack || t < -kSlack || s + t > 1.0 + kSlack) continue;
        const double z = mesh.vertices[f[0]].z() * (1.0 - s - t) + mesh.vertices[f[1]].z() * s +
                         mesh.vertices[f[2]].z() * t;
        float& out = (*heights)(r, c);
        if (!(out >= z)) out = static_cast<float>(z);
      }
    }
  }
}

}  // namespace

HeightField RasterizeMesh(const TriangleMesh& mesh, double pitch_mm, const Context& context) {
  HeightField field;
  field.pitch_mm = pitch_mm;
  if (mesh.faces.empty()) return field;
  Eigen::Vector2d low = mesh.vertices[0].head<2>(), high = low;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
  // Origins on whole multiples of the pitch, so that the fields of repeats lie on the same grid.
  field.origin_mm = (low / pitch_mm).array().floor() * pitch_mm;
  const Eigen::Vector2d size = (high - field.origin_mm) / pitch_mm;
  field.z = cv::Mat1f(static_cast<int>(std::ceil(size.y())) + 1, static_cast<int>(std::ceil(size.x())) + 1,
                      std::numeric_limits<float>::quiet_NaN());
  // Two halves side by side; the higher of both counts.
  cv::Mat1f second = field.z.clone();
  const std::size_t half = mesh.faces.size() / 2;
  ParallelFor(context, 0, 2, [&](std::int64_t part) {
    if (part == 0) {
      DrawFaces(mesh, 0, half, field, &field.z);
    } else {
      DrawFaces(mesh, half, mesh.faces.size(), field, &second);
    }
  });
  for (int r = 0; r < field.z.rows; ++r) {
    auto* to = field.z.ptr<float>(r);
    const auto* other = second.ptr<float>(r);
    for (int c = 0; c < field.z.cols; ++c) {
      if (!std::isnan(other[c]) && !(to[c] >= other[c])) to[c] = other[c];
    }
  }
  return field;
}

}  // namespace dorsum
