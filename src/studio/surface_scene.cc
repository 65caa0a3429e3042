// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>

namespace dorsum {
namespace {

constexpr double kNear_mm = 2.0;  // a stripe point so near to a picked place of the mesh belongs to it

SceneVertex MakeVertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, const Colour& colour) {
  SceneVertex vertex;
  for (std::size_t i = 0; i < 3; ++i) {
    vertex.position[i] = static_cast<float>(position[static_cast<int>(i)]);
    vertex.normal[i] = static_cast<float>(normal[static_cast<int>(i)]);
    vertex.colour[i] = colour[2 - static_cast<int>(i)];
  }
  return vertex;
}

// Those of the mesh, or the mean of the faces' normals by their areas.
std::vector<Eigen::Vector3d> NormalsOf(const TriangleMesh& mesh) {
  if (mesh.normals.size() == mesh.vertices.size()) return mesh.normals;
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (const auto& f : mesh.faces) {
    const Eigen::Vector3d& a = mesh.vertices[f[0]];
    const Eigen::Vector3d n = (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a);
    for (const std::uint32_t i : f) normals[i] += n;
  }
  for (Eigen::Vector3d& n : normals) {
    n = n.squaredNorm() > 0.0 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::UnitZ();
  }
  return normals;
}

// Stepping by a stride that shares no divisor with the count visits all, and any first n of them evenly
// where the stride is the golden section of the count.
std::vector<std::uint32_t> SpreadOrder(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::size_t stride =
      std::max<std::size_t>(1, static_cast<std::size_t>(0.6180339887 * static_cast<double>(count)));
  while (std::gcd(stride, count) != 1 && count > 1) ++stride;
  for (std::size_t i = 0, at = 0; i < count; ++i, at = (at + stride) % count) {
    order[i] = static_cast<std::uint32_t>(at);
  }
  return order;
}

// Distance along the ray to a triangle, mm (Möller and Trumbore 1997), seen from either side.
std::optional<double> Meet(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, p = ray.direction.cross(ac);
  const double det = ab.dot(p);
  if (std::abs(det) < 1e-15) return std::nullopt;
  const Eigen::Vector3d from = ray.origin - a;
  const double u = from.dot(p) / det;
  if (!(u >= -1e-9 && u <= 1.0 + 1e-9)) return std::nullopt;
  const Eigen::Vector3d q = from.cross(ab);
  const double v = ray.direction.dot(q) / det;
  if (!(v >= -1e-9 && u + v <= 1.0 + 1e-9)) return std::nullopt;
  const double t = ac.dot(q) / det;
  if (!(t > 0.0)) return std::nullopt;
  return t;
}

struct Hit {
  double along = std::numeric_limits<double>::infinity();
  std::uint32_t index = 0;
};

Hit MeetMesh(const TriangleMesh& mesh, const Ray& ray) {
  Hit best;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    const auto t = Meet(ray, mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]);
    if (t && *t < best.along) best = {*t, f};
  }
  return best;
}

// A point in front beats a better aimed one behind it only by more than it is off the ray.
Hit MeetPoints(const SurfacePoints& points, const Ray& ray, double slope) {
  Hit best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d d = points[i].position - ray.origin;
    const double along = ray.direction.dot(d);
    if (!(along > 0.0)) continue;
    const double off = std::sqrt(std::max(d.squaredNorm() - along * along, 0.0));
    if (off > slope * along || along + 2.0 * off >= least) continue;
    least = along + 2.0 * off;
    best = {along, i};
  }
  return best;
}

std::optional<std::uint32_t> NearestPoint(const SurfacePoints& points, const Eigen::Vector3d& place) {
  std::optional<std::uint32_t> best;
  double least = kNear_mm * kNear_mm;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double d = (points[i].position - place).squaredNorm();
    if (!(d <= least)) continue;
    least = d;
    best = i;
  }
  return best;
}

}  // namespace

SceneBuffers MakeBuffers(const Reconstruction& surface, ColourBy by, const OtherHeight& other) {
  SceneBuffers buffers;
  const std::vector<float> of_points = PointValues(surface.points, by, other);
  const std::vector<float> of_vertices = VertexValues(surface, by, other);
  buffers.scale = MakeScale(by, of_points, of_vertices);
  if (by == ColourBy::kDifference) {
    buffers.difference = Summarize(surface.mesh.faces.empty() ? of_points : of_vertices);
  }
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(kFar), high = -low;
  const auto bound = [&](const Eigen::Vector3d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  buffers.points.reserve(surface.points.size());
  for (const std::uint32_t i : SpreadOrder(surface.points.size())) {
    const SurfacePoint& p = surface.points[i];
    if (!p.position.allFinite()) continue;
    buffers.points.push_back(MakeVertex(p.position, p.normal.cast<double>(), buffers.scale.At(of_points[i])));
    bound(p.position);
  }
  const std::vector<Eigen::Vector3d> normals = NormalsOf(surface.mesh);
  buffers.vertices.reserve(surface.mesh.vertices.size());
  for (std::size_t i = 0; i < surface.mesh.vertices.size(); ++i) {
    const Eigen::Vector3d& v = surface.mesh.vertices[i];
    buffers.vertices.push_back(MakeVertex(v, normals[i], buffers.scale.At(of_vertices[i])));
    if (v.allFinite()) bound(v);
  }
  buffers.triangles.reserve(3 * surface.mesh.faces.size());
  for (const auto& f : surface.mesh.faces)
    buffers.triangles.insert(buffers.triangles.end(), f.begin(), f.end());
  if (low.allFinite()) {
    buffers.low = low;
    buffers.high = high;
  }
  return buffers;
}

std::optional<Picked> Pick(const Scan& scan, const Ray& ray, Shown shown, double slope) {
  const Reconstruction& surface = scan.surface;
  const Hit mesh = shown == Shown::kPoints ? Hit{} : MeetMesh(surface.mesh, ray);
  const Hit point = shown == Shown::kMesh ? Hit{} : MeetPoints(surface.points, ray, slope);
  Picked picked;
  // Points lie on the mesh, half in front of it and half behind: with both shown, one that is aimed at wins.
  if (std::isfinite(point.along) && point.along < mesh.along + kNear_mm) {
    picked.position = surface.points[point.index].position;
    picked.point = point.index;
    if (std::isfinite(mesh.along) && mesh.along < point.along + kNear_mm) picked.face = mesh.index;
  } else if (std::isfinite(mesh.along)) {
    picked.position = ray.At(mesh.along);
    picked.face = mesh.index;
    picked.point = NearestPoint(surface.points, picked.position);
  } else {
    return std::nullopt;
  }
  if (scan.calibration) {
    picked.image = Project(scan.calibration->calibration.device.camera, picked.position);
  } else if (picked.point && !picked.face) {
    picked.image = Eigen::Vector2d(surface.points[*picked.point].u, surface.points[*picked.point].v);
  }
  return picked;
}

std::optional<std::uint32_t> PickInImage(const SurfacePoints& points, const Eigen::Vector2d& pixel,
                                         std::optional<int> laser, double reach_px) {
  std::optional<std::uint32_t> best;
  double least = reach_px;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (laser && points[i].laser != *laser) continue;
    const double d = std::hypot(points[i].u - pixel.x(), points[i].v - pixel.y());
    if (!(d <= least)) continue;
    least = d;
    best = i;
  }
  return best;
}

std::vector<std::uint32_t> PointsOfStripe(const SurfacePoints& points, const StripeKey& key) {
  std::vector<std::uint32_t> stripe;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (KeyOf(points[i]) == key) stripe.push_back(i);
  }
  std::stable_sort(stripe.begin(), stripe.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return points[a].v < points[b].v; });
  return stripe;
}

}  // namespace dorsum
