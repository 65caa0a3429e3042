// SPDX-License-Identifier: Apache-2.0
#include "surface/height_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <nanoflann.hpp>

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

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

struct MeshAdaptor {
  const std::vector<Eigen::Vector3d>& vertices;
  std::size_t kdtree_get_point_count() const { return vertices.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t d) const {
    return vertices[i][static_cast<Eigen::Index>(d)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
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

void AssignNormals(const TriangleMesh& mesh, double max_distance_mm, SurfacePoints* points) {
  if (mesh.vertices.empty()) return;
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, MeshAdaptor>, MeshAdaptor, 3>;
  const MeshAdaptor adaptor{mesh.vertices};
  Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  tree.buildIndex();
  for (SurfacePoint& p : *points) {
    std::size_t nearest = 0;
    double square = std::numeric_limits<double>::max();
    nanoflann::KNNResultSet<double> result(1);
    result.init(&nearest, &square);
    tree.findNeighbors(result, p.position.data(), nanoflann::SearchParams());
    if (square <= max_distance_mm * max_distance_mm) p.normal = mesh.normals[nearest];
  }
}

}  // namespace dorsum
