// SPDX-License-Identifier: Apache-2.0
#include "surface/lattice_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class LatticeMesher {
 public:
  LatticeMesher(const PlateLattice& lattice, const Outline& outline, const RayField& rays,
                double max_slope_deg)
      : l_(lattice),
        rays_(rays),
        inside_(outline.AtNodes(l_.u0, l_.v0, l_.step_px, l_.active.size())),
        max_tilt_(1.0 + std::pow(std::tan(max_slope_deg * std::numbers::pi / 180.0), 2)) {
    for (auto& ids : ids_) ids.assign(l_.active.total(), kNone);
    const auto nodes = static_cast<std::size_t>(cv::countNonZero(l_.active));
    mesh_.vertices.reserve(nodes);
    mesh_.faces.reserve(2 * nodes);
  }

  TriangleMesh Mesh() {
    for (int r = 0; r + 1 < l_.active.rows; ++r) {
      for (int c = 0; c + 1 < l_.active.cols; ++c) MeshCell(c, r);
    }
    return std::move(mesh_);
  }

 private:
  struct Corner {
    int c, r;
  };

  std::uint32_t AddVertex(double c, double r, double z) {
    mesh_.vertices.push_back(rays_.At(l_.u0 + l_.step_px * c, l_.v0 + l_.step_px * r, z));
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  std::size_t Index(const Corner& at) const {
    return static_cast<std::size_t>(at.r) * static_cast<std::size_t>(l_.active.cols) +
           static_cast<std::size_t>(at.c);
  }

  std::uint32_t Node(const Corner& at) {
    std::uint32_t& id = ids_[0][Index(at)];
    if (id == kNone) id = AddVertex(at.c, at.r, l_.z(at.r, at.c));
    return id;
  }

  // The vertex where the outline crosses the edge between two neighbouring nodes.
  std::uint32_t Crossing(Corner a, Corner b) {
    if (b.c < a.c || b.r < a.r) std::swap(a, b);
    std::uint32_t& id = ids_[a.r == b.r ? 1 : 2][Index(a)];
    if (id != kNone) return id;
    const double da = inside_(a.r, a.c), db = inside_(b.r, b.c);
    const double t = std::clamp(da / (da - db), 0.02, 0.98);
    id = AddVertex(a.c + t * (b.c - a.c), a.r + t * (b.r - a.r),
                   l_.z(a.r, a.c) + t * (l_.z(b.r, b.c) - l_.z(a.r, a.c)));
    return id;
  }

  void MeshCell(int c, int r) {
    const auto *on = l_.active.ptr<std::uint8_t>(r) + c, *on_south = l_.active.ptr<std::uint8_t>(r + 1) + c;
    if (on[0] == 0 || on[1] == 0 || on_south[0] == 0 || on_south[1] == 0) return;
    const std::array<Corner, 4> corners = {Corner{c, r}, Corner{c + 1, r}, Corner{c + 1, r + 1},
                                           Corner{c, r + 1}};
    const auto *in = inside_.ptr<float>(r) + c, *in_south = inside_.ptr<float>(r + 1) + c;
    if (std::max({in[0], in[1], in_south[0], in_south[1]}) <= 0.0F) return;
    if (std::min({in[0], in[1], in_south[0], in_south[1]}) > 0.0F) {
      const std::uint32_t first = Node(corners[0]), second = Node(corners[1]), third = Node(corners[2]),
                          fourth = Node(corners[3]);
      AddFace(first, second, third);
      AddFace(first, third, fourth);
      return;
    }
    // The part of the cell that lies inside, as a polygon of at most six corners.
    std::array<std::uint32_t, 8> polygon{};
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Corner &a = corners[i], &b = corners[(i + 1) % 4];
      const bool in_a = inside_(a.r, a.c) > 0.0F, in_b = inside_(b.r, b.c) > 0.0F;
      if (in_a) polygon[size++] = Node(a);
      if (in_a != in_b) polygon[size++] = Crossing(a, b);
    }
    for (std::size_t i = 1; i + 1 < size; ++i) AddFace(polygon[0], polygon[i], polygon[i + 1]);
  }

  void AddFace(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Eigen::Vector3d &pa = mesh_.vertices[a], &pb = mesh_.vertices[b], &pc = mesh_.vertices[c];
    const Eigen::Vector3d normal = (pb - pa).cross(pc - pa);
    const Eigen::Vector3d view = (pa + pb + pc) / 3.0 - rays_.center();
    const double along = normal.dot(view);
    // The square of 1 / cosine of the slope.
    if (!(normal.squaredNorm() * view.squaredNorm() <= max_tilt_ * along * along)) return;
    // Rows of the image run against y, so the polygon's turn depends on the camera.
    if (along > 0.0) std::swap(b, c);
    mesh_.faces.push_back({a, b, c});
  }

  const PlateLattice& l_;
  const RayField& rays_;
  cv::Mat1f inside_;
  double max_tilt_ = 1.0;
  std::array<std::vector<std::uint32_t>, 3> ids_;  // of nodes, of crossings to the right and below
  TriangleMesh mesh_;
};

void DropLooseVertices(TriangleMesh* mesh) {
  std::vector<std::uint32_t> ids(mesh->vertices.size(), kNone);
  std::vector<Eigen::Vector3d> kept;
  kept.reserve(mesh->vertices.size());
  for (auto& f : mesh->faces) {
    for (std::uint32_t& i : f) {
      if (ids[i] == kNone) {
        ids[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh->vertices[i]);
      }
      i = ids[i];
    }
  }
  mesh->vertices = std::move(kept);
}

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

TriangleMesh MeshLattice(const PlateLattice& lattice, const Outline& outline, const RayField& rays,
                         double max_slope_deg) {
  TriangleMesh mesh = LatticeMesher(lattice, outline, rays, max_slope_deg).Mesh();
  DropLooseVertices(&mesh);
  ComputeNormals(&mesh);
  return mesh;
}

HeightField RasterizeMesh(const TriangleMesh& mesh, double pitch_mm) {
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
  for (const auto& f : mesh.faces) {
    std::array<Eigen::Vector2d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = (mesh.vertices[f[i]].head<2>() - field.origin_mm) / pitch_mm;
    const Eigen::Vector2d e1 = p[1] - p[0], e2 = p[2] - p[0];
    const double area = e1.x() * e2.y() - e1.y() * e2.x();
    if (std::abs(area) < 1e-12) continue;
    const auto [c0, c1] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [r0, r1] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for (int r = static_cast<int>(std::ceil(r0)); r <= static_cast<int>(std::floor(r1)); ++r) {
      for (int c = static_cast<int>(std::ceil(c0)); c <= static_cast<int>(std::floor(c1)); ++c) {
        const Eigen::Vector2d q(c - p[0].x(), r - p[0].y());
        const double s = (q.x() * e2.y() - q.y() * e2.x()) / area,
                     t = (e1.x() * q.y() - e1.y() * q.x()) / area;
        constexpr double kSlack = 1e-9;
        if (s < -kSlack || t < -kSlack || s + t > 1.0 + kSlack) continue;
        const double z = mesh.vertices[f[0]].z() * (1.0 - s - t) + mesh.vertices[f[1]].z() * s +
                         mesh.vertices[f[2]].z() * t;
        float& out = field.z(r, c);
        if (!(out >= z)) out = static_cast<float>(z);
      }
    }
  }
  return field;
}

}  // namespace dorsum
