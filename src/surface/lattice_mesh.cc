// SPDX-License-Identifier: Apache-2.0
#include "surface/lattice_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/parallel.h"
#include "surface/mesh_parts.h"

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = MeshPart::kNone;

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

  // With what the parts above and below have too.
  MeshPart Take() {
    std::vector<std::uint32_t> first = VerticesOfRow(first_), last = VerticesOfRow(last_);
    return {std::move(mesh_), std::move(first), std::move(last)};
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

}  // namespace

TriangleMesh MeshLattice(const PlateLattice& lattice, const Outline& outline, const RayField& rays,
                         double max_slope_deg, const Context& context) {
  constexpr int kParts = 4;
  const PlateLattice& l = lattice;
  const cv::Mat1f inside = outline.AtNodes(l.u0, l.v0, l.step_px, l.active.size(), context);
  if (l.active.rows < 2) return {};
  std::vector<MeshPart> parts(kParts);
  ParallelFor(context, 0, kParts, [&](std::int64_t k) {
    const int cells = l.active.rows - 1, part = static_cast<int>(k);
    parts[static_cast<std::size_t>(k)] =
        LatticeMesher(l, inside, rays, max_slope_deg, part * cells / kParts, (part + 1) * cells / kParts)
            .Take();
  });
  return JoinParts(parts, context);
}

}  // namespace dorsum
