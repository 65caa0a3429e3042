// SPDX-License-Identifier: Apache-2.0
#include "surface/height_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr double kCellMm = 0.5;  // about as far as a point is from the nearest vertex

// The three grid corners of a triangle, as (column, row).
using Corners = std::array<cv::Point, 3>;

bool IsSurface(const cv::Mat1f& z, const Corners& corners, double max_step) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const cv::Point& c : corners) {
    const float value = z(c);
    if (!std::isfinite(value)) return false;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high - low <= max_step;
}

// Vertices in square cells of the backplane, to find the nearest of one.
class VertexCells {
 public:
  // `vertices` must outlive it.
  VertexCells(const std::vector<Eigen::Vector3d>& vertices, double cell_mm)
      : vertices_(vertices), cell_mm_(cell_mm), low_(vertices[0].head<2>()) {
    Eigen::Vector2d high = low_;
    for (const Eigen::Vector3d& p : vertices) {
      low_ = low_.cwiseMin(p.head<2>());
      high = high.cwiseMax(p.head<2>());
    }
    cols_ = Cell(high.x() - low_.x()) + 1;
    rows_ = Cell(high.y() - low_.y()) + 1;
    begin_.assign(static_cast<std::size_t>(cols_ * rows_) + 1, 0);
    for (const Eigen::Vector3d& p : vertices) ++begin_[At(p) + 1];
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    sorted_.resize(vertices.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      sorted_[next[At(vertices[i])]++] = static_cast<std::uint32_t>(i);
  }

  // kNone if the nearest is further away than that.
  std::uint32_t Nearest(const Eigen::Vector3d& p, double max_distance_mm) const {
    std::uint32_t nearest = kNone;
    double square = max_distance_mm * max_distance_mm;
    const long c = Cell(p.x() - low_.x()), r = Cell(p.y() - low_.y());
    const long rings = Cell(max_distance_mm) + 1;
    // What lies in a ring of cells around the place's own is at least so many cells, less one, away.
    for (long ring = 0; ring <= rings; ++ring) {
      const double least = std::max(0.0, static_cast<double>(ring - 1)) * cell_mm_;
      if (least * least > square) break;
      for (long y = std::max(0L, r - ring); y <= std::min(rows_ - 1, r + ring); ++y) {
        const long step = y == r - ring || y == r + ring ? 1 : std::max(1L, 2 * ring);
        for (long x = c - ring; x <= c + ring; x += step) {
          if (x < 0 || x >= cols_) continue;
          const auto cell = static_cast<std::size_t>(y * cols_ + x);
          for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
            const double d = (vertices_[sorted_[i]] - p).squaredNorm();
            if (d > square || (d == square && nearest != kNone)) continue;
            square = d;
            nearest = sorted_[i];
          }
        }
      }
    }
    return nearest;
  }

 private:
  long Cell(double mm) const { return static_cast<long>(std::floor(mm / cell_mm_)); }
  std::size_t At(const Eigen::Vector3d& p) const {
    return static_cast<std::size_t>(Cell(p.y() - low_.y()) * cols_ + Cell(p.x() - low_.x()));
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  double cell_mm_;
  Eigen::Vector2d low_;
  long cols_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_;   // of each cell in `sorted_`
  std::vector<std::uint32_t> sorted_;  // vertices by their cells
};

void ComputeNormals(TriangleMesh* mesh) {
  mesh->normals.assign(mesh->vertices.size(), Eigen::Vector3d::Zero());
  for (const auto& f : mesh->faces) {
    const Eigen::Vector3d& a = mesh->vertices[f[0]];
    const Eigen::Vector3d area = (mesh->vertices[f[1]] - a).cross(mesh->vertices[f[2]] - a);
    for (const std::uint32_t i : f) mesh->normals[i] += area;
  }
  for (Eigen::Vector3d& n : mesh->normals) n.normalize();
}

}  // namespace

TriangleMesh MeshHeightField(const HeightField& field, double max_slope_deg) {
  TriangleMesh mesh;
  const double max_step = std::tan(max_slope_deg * std::numbers::pi / 180.0) * field.pitch_mm;
  std::vector<std::uint32_t> ids(field.z.total(), kNone);
  const auto vertex = [&](const cv::Point& c) {
    std::uint32_t& id = ids[static_cast<std::size_t>(c.y) * static_cast<std::size_t>(field.z.cols) +
                            static_cast<std::size_t>(c.x)];
    if (id == kNone) {
      id = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.emplace_back(field.origin_mm.x() + c.x * field.pitch_mm,
                                 field.origin_mm.y() + c.y * field.pitch_mm, field.z(c));
    }
    return id;
  };
  for (int r = 0; r + 1 < field.z.rows; ++r) {
    for (int c = 0; c + 1 < field.z.cols; ++c) {
      const cv::Point p00(c, r), p10(c + 1, r), p01(c, r + 1), p11(c + 1, r + 1);
      for (const Corners& t : {Corners{p00, p10, p11}, Corners{p00, p11, p01}}) {
        if (IsSurface(field.z, t, max_step)) mesh.faces.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
      }
    }
  }
  ComputeNormals(&mesh);
  return mesh;
}

void AssignNormals(const TriangleMesh& mesh, double max_distance_mm, SurfacePoints* points,
                   const Context& context) {
  if (mesh.vertices.empty()) return;
  const VertexCells cells(mesh.vertices, kCellMm);
  constexpr std::size_t kTogether = 1024;
  const auto parts = static_cast<std::int64_t>((points->size() + kTogether - 1) / kTogether);
  ParallelFor(context, 0, parts, [&](std::int64_t part) {
    const std::size_t begin = static_cast<std::size_t>(part) * kTogether;
    for (std::size_t i = begin; i < std::min(points->size(), begin + kTogether); ++i) {
      SurfacePoint& p = (*points)[i];
      const std::uint32_t nearest = cells.Nearest(p.position, max_distance_mm);
      if (nearest != kNone) p.normal = mesh.normals[nearest].cast<float>();
    }
  });
}

}  // namespace dorsum
