// SPDX-License-Identifier: Apache-2.0
#include "surface/lattice_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class LatticeMesher {
 public:
  // `inside`: the distance to the outline at the nodes. The cells between the rows `first` and `last`.
  LatticeMesher(const PlateLattice& lattice, const cv::Mat1f& inside, const RayField& rays,
                double max_slope_deg, int first, int last)
      : l_(lattice),
        rays_(rays),
        inside_(inside),
        max_tilt_(1.0 + std::pow(std::tan(max_slope_deg * std::numbers::pi / 180.0), 2)),
        first_(first),
        last_(last) {
    const cv::Mat active = l_.active.rowRange(first, last + 1);
    for (auto& ids : ids_) ids.assign(active.total(), kNone);
    const auto nodes = static_cast<std::size_t>(cv::countNonZero(active));
    mesh_.vertices.reserve(nodes);
    mesh_.faces.reserve(2 * nodes);
    for (int r = first_; r < last_; ++r) {
      for (int c = 0; c + 1 < l_.active.cols; ++c) MeshCell(c, r);
    }
  }

  const TriangleMesh& mesh() const { return mesh_; }

  // Adds this part to `whole`, which holds those above it; `ids` are the vertices of `whole` on the row that
  // both share, and then those on this part's last row.
  void AddTo(TriangleMesh* whole, std::vector<std::uint32_t>* ids) const {
    std::vector<std::uint32_t> to(mesh_.vertices.size(), kNone);
    const std::vector<std::uint32_t> top = VerticesOfRow(first_);
    for (std::size_t i = 0; i < top.size() && i < ids->size(); ++i) {
      if (top[i] != kNone) to[top[i]] = (*ids)[i];
    }
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (to[i] != kNone) continue;
      to[i] = static_cast<std::uint32_t>(whole->vertices.size());
      whole->vertices.push_back(mesh_.vertices[i]);
    }
    for (const auto& f : mesh_.faces) whole->faces.push_back({to[f[0]], to[f[1]], to[f[2]]});
    *ids = VerticesOfRow(last_);
    for (std::uint32_t& id : *ids) id = id == kNone ? kNone : to[id];
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
    return static_cast<std::size_t>(at.r - first_) * static_cast<std::size_t>(l_.active.cols) +
           static_cast<std::size_t>(at.c);
  }

  // Those at the nodes of a row, then those between them.
  std::vector<std::uint32_t> VerticesOfRow(int row) const {
    std::vector<std::uint32_t> out;
    for (std::size_t kind = 0; kind < 2; ++kind) {
      const auto begin = ids_[kind].begin() + static_cast<std::ptrdiff_t>(Index({0, row}));
      out.insert(out.end(), begin, begin + l_.active.cols);
    }
    return out;
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
  const cv::Mat1f& inside_;
  double max_tilt_ = 1.0;
  int first_, last_;                               // rows of nodes
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
                         double max_slope_deg, const Context& context) {
  constexpr int kParts = 4;
  const PlateLattice& l = lattice;
  const cv::Mat1f inside = outline.AtNodes(l.u0, l.v0, l.step_px, l.active.size(), context);
  TriangleMesh mesh;
  if (l.active.rows < 2) return mesh;
  std::vector<std::optional<LatticeMesher>> parts(kParts);
  ParallelFor(context, 0, kParts, [&](std::int64_t k) {
    const int cells = l.active.rows - 1, part = static_cast<int>(k);
    parts[static_cast<std::size_t>(k)].emplace(l, inside, rays, max_slope_deg, part * cells / kParts,
                                               (part + 1) * cells / kParts);
  });
  std::size_t vertices = 0, faces = 0;
  for (const auto& part : parts) {
    vertices += part->mesh().vertices.size();
    faces += part->mesh().faces.size();
  }
  mesh.vertices.reserve(vertices);
  mesh.faces.reserve(faces);
  std::vector<std::uint32_t> shared;
  for (const auto& part : parts) part->AddTo(&mesh, &shared);
  DropLooseVertices(&mesh);
  ComputeNormals(&mesh);
  return mesh;
}

}  // namespace dorsum
