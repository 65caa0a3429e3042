// SPDX-License-Identifier: Apache-2.0
#include "report/mesh_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr int kSkyRays = 40;

// Directions about +z, as many per solid angle as the cosine law asks for, so that each counts the same. One
// fixed set for all places: the error is then the same everywhere and does not show as noise.
std::vector<Eigen::Vector3d> SkyDirections() {
  std::vector<Eigen::Vector3d> directions;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < kSkyRays; ++i) {
    const double radius = std::sqrt((i + 0.5) / kSkyRays);
    directions.emplace_back(radius * std::cos(golden * i), radius * std::sin(golden * i),
                            std::sqrt(1.0 - radius * radius));
  }
  return directions;
}

double Sky(const MeshTracer& tracer, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
           double reach_mm, const std::vector<Eigen::Vector3d>& directions) {
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal).toRotationMatrix();
  const Eigen::Vector3d start = point + 0.05 * normal;
  int open = 0;
  for (const Eigen::Vector3d& local : directions) {
    const Ray ray{start, turn * local};
    const bool meets_floor = ray.direction.z() < 0.0 && start.z() < -reach_mm * ray.direction.z();
    if (!meets_floor && !tracer.IsBlocked(ray, 0.05, reach_mm)) ++open;
  }
  return double(open) / kSkyRays;
}

}  // namespace

std::vector<Eigen::Vector3d> VertexNormals(const TriangleMesh& mesh) {
  if (mesh.normals.size() == mesh.vertices.size()) return mesh.normals;
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (const auto& face : mesh.faces) {
    const Eigen::Vector3d& a = mesh.vertices.at(face[0]);
    const Eigen::Vector3d twice_area = (mesh.vertices.at(face[1]) - a).cross(mesh.vertices.at(face[2]) - a);
    if (!twice_area.allFinite()) continue;
    for (const std::uint32_t vertex : face) normals[vertex] += twice_area;
  }
  for (Eigen::Vector3d& normal : normals) {
    normal = normal.squaredNorm() > 0.0 ? normal.normalized() : Eigen::Vector3d::UnitZ();
  }
  return normals;
}

std::vector<float> VertexSky(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                             const MeshTracer& tracer, double reach_mm, const Context& context) {
  std::vector<float> sky(mesh.vertices.size(), 1.0F);
  const std::vector<Eigen::Vector3d> directions = SkyDirections();
  constexpr std::int64_t kBatch = 1024;
  const auto count = static_cast<std::int64_t>(sky.size());
  ParallelFor(context, 0, (count + kBatch - 1) / kBatch, [&](std::int64_t batch) {
    for (std::int64_t i = batch * kBatch; i < std::min(count, (batch + 1) * kBatch); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (!mesh.vertices[k].allFinite()) continue;
      sky[k] = static_cast<float>(Sky(tracer, mesh.vertices[k], normals[k], reach_mm, directions));
    }
  });
  return sky;
}

double FloorShadow::At(double x, double y) const {
  const double c = (x - origin_mm.x()) / pitch_mm, r = (y - origin_mm.y()) / pitch_mm;
  if (c < 0.0 || r < 0.0 || c >= sky.cols - 1 || r >= sky.rows - 1) return 1.0;
  const int c0 = static_cast<int>(c), r0 = static_cast<int>(r);
  const double fc = c - c0, fr = r - r0;
  return (1.0 - fr) * ((1.0 - fc) * sky(r0, c0) + fc * sky(r0, c0 + 1)) +
         fr * ((1.0 - fc) * sky(r0 + 1, c0) + fc * sky(r0 + 1, c0 + 1));
}

FloorShadow ShadeFloor(const TriangleMesh& mesh, const MeshTracer& tracer, double reach_mm,
                       const Context& context) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    if (!v.allFinite()) continue;
    low = low.cwiseMin(v.head<2>());
    high = high.cwiseMax(v.head<2>());
  }
  FloorShadow shadow;
  if (!(low.array() <= high.array()).all()) return shadow;
  shadow.pitch_mm = std::max(2.0, (high - low).maxCoeff() / 250.0);
  shadow.origin_mm = low.array() - reach_mm;
  const Eigen::Vector2d cells = ((high - low).array() + 2.0 * reach_mm) / shadow.pitch_mm + 2.0;
  shadow.sky = cv::Mat1f(static_cast<int>(cells.y()), static_cast<int>(cells.x()), 1.0F);
  const std::vector<Eigen::Vector3d> directions = SkyDirections();
  ParallelFor(context, 0, shadow.sky.rows, [&](std::int64_t i) {
    const int row = static_cast<int>(i);
    for (int column = 0; column < shadow.sky.cols; ++column) {
      const Eigen::Vector3d place(shadow.origin_mm.x() + column * shadow.pitch_mm,
                                  shadow.origin_mm.y() + row * shadow.pitch_mm, 0.0);
      shadow.sky(row, column) =
          static_cast<float>(Sky(tracer, place, Eigen::Vector3d::UnitZ(), reach_mm, directions));
    }
  });
  return shadow;
}

}  // namespace dorsum
