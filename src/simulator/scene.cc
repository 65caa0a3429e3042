// SPDX-License-Identifier: Apache-2.0
#include "simulator/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace dorsum {
namespace {

using Corners = std::array<Eigen::Vector3d, 4>;

// A flat quadrangle with its own vertices; corners counter-clockwise seen from outside.
void AddQuad(TriangleMesh& mesh, const Corners& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.faces.push_back({first, first + 1, first + 2});
  mesh.faces.push_back({first, first + 2, first + 3});
}

// Walls and lid of a prism over a rectangle; `lower` and `upper` run counter-clockwise seen from above.
void AddSidesAndTop(TriangleMesh& mesh, const Corners& lower, const Corners& upper) {
  AddQuad(mesh, upper);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    AddQuad(mesh, {lower[i], lower[j], upper[j], upper[i]});
  }
}

Corners Rectangle(const Rigid3& world_from_local, const Eigen::Vector2d& size, double z) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y();
  return {world_from_local * Eigen::Vector3d(-x, -y, z), world_from_local * Eigen::Vector3d(x, -y, z),
          world_from_local * Eigen::Vector3d(x, y, z), world_from_local * Eigen::Vector3d(-x, y, z)};
}

Rigid3 OnBackplane(const Eigen::Vector2d& centre, double yaw) {
  Rigid3 world_from_local;
  world_from_local.rotation = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  world_from_local.translation << centre, 0.0;
  return world_from_local;
}

TriangleMesh BoxMesh(const BoxPlace& place) {
  const Rigid3 world_from_box = OnBackplane(place.centre_mm, place.yaw);
  TriangleMesh mesh;
  AddSidesAndTop(mesh, Rectangle(world_from_box, place.size_mm, 0.0),
                 Rectangle(world_from_box, place.size_mm, place.height_mm));
  return mesh;
}

}  // namespace

ScenePart Backplane() {
  ScenePart part;
  AddQuad(part.mesh, Rectangle(Rigid3{}, {3000.0, 3000.0}, 0.0));
  part.mottle = 0.02;
  part.is_object = false;
  return part;
}

ScenePart BrownBox(const BoxPlace& place) {
  ScenePart part;
  part.mesh = BoxMesh(place);
  part.paint = {Material::kBrown, 0.33};
  part.mottle = 0.06;
  return part;
}

ScenePart WhiteBox(const BoxPlace& place) {
  ScenePart part;
  part.mesh = BoxMesh(place);
  part.paint = {Material::kBoardWhite, 0.82};
  part.mottle = 0.01;
  return part;
}

ScenePart WhitePlate(const Rigid3& world_from_plate, const Eigen::Vector2d& size_mm, double thickness_mm) {
  ScenePart part;
  const Corners upper = Rectangle(world_from_plate, size_mm, 0.0);
  const Corners lower = Rectangle(world_from_plate, size_mm, -thickness_mm);
  AddSidesAndTop(part.mesh, lower, upper);
  AddQuad(part.mesh, {lower[3], lower[2], lower[1], lower[0]});
  part.paint = {Material::kBoardWhite, 0.82};
  part.mottle = 0.01;
  return part;
}

ScenePart LyingCylinder(double radius_mm, double length_mm, const Eigen::Vector2d& centre_mm, double yaw) {
  // A chord stays within radius * (1 - cos(pi / n)) of the circle.
  constexpr double kTolerance = 0.0005;  // mm
  const int n = static_cast<int>(std::ceil(std::numbers::pi / std::acos(1.0 - kTolerance / radius_mm)));
  const Rigid3 world_from_cylinder = OnBackplane(centre_mm, yaw);
  const double half = 0.5 * length_mm;
  ScenePart part;
  TriangleMesh& mesh = part.mesh;
  const auto add = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
    mesh.vertices.push_back(world_from_cylinder * p);
    mesh.normals.emplace_back(world_from_cylinder.rotation * normal);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  };
  for (int i = 0; i <= n; ++i) {  // the skin: pairs of vertices along the axis
    const double angle = 2.0 * std::numbers::pi * i / n;
    const Eigen::Vector3d normal(0.0, std::cos(angle), std::sin(angle));
    const Eigen::Vector3d rim = radius_mm * normal + Eigen::Vector3d(0.0, 0.0, radius_mm);
    const auto left = add(rim - Eigen::Vector3d(half, 0.0, 0.0), normal);
    const auto right = add(rim + Eigen::Vector3d(half, 0.0, 0.0), normal);
    if (i == 0) continue;
    mesh.faces.push_back({left - 2, left, right - 2});
    mesh.faces.push_back({left, right, right - 2});
  }
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d normal(side, 0.0, 0.0);
    const auto middle = add({side * half, 0.0, radius_mm}, normal);
    for (int i = 0; i <= n; ++i) {
      const double angle = side * 2.0 * std::numbers::pi * i / n;
      const auto rim =
          add({side * half, radius_mm * std::cos(angle), radius_mm * (1.0 + std::sin(angle))}, normal);
      if (i > 0) mesh.faces.push_back({middle, rim - 1, rim});
    }
  }
  part.paint = {Material::kGrey, 0.42};
  return part;
}

ScenePart HalfSphere(double radius_mm, const Eigen::Vector2d& centre_mm) {
  // Two crossing chords of angle d leave at most radius * d^2 / 4 between facet and sphere.
  constexpr double kTolerance = 0.001;  // mm
  const double d = std::sqrt(4.0 * kTolerance / radius_mm);
  const int rings = static_cast<int>(std::ceil(0.5 * std::numbers::pi / d));
  const int sectors = 4 * rings;
  ScenePart part;
  TriangleMesh& mesh = part.mesh;
  for (int i = 0; i <= rings; ++i) {  // from the rim on the backplane up to the pole
    const double latitude = 0.5 * std::numbers::pi * i / rings;
    for (int j = 0; j <= sectors; ++j) {
      const double longitude = 2.0 * std::numbers::pi * j / sectors;
      const Eigen::Vector3d normal(std::cos(latitude) * std::cos(longitude),
                                   std::cos(latitude) * std::sin(longitude),
                                   i == 0 ? 0.0 : std::sin(latitude));
      mesh.vertices.emplace_back(radius_mm * normal + Eigen::Vector3d(centre_mm.x(), centre_mm.y(), 0.0));
      mesh.normals.push_back(normal);
      if (i == 0 || j == 0) continue;
      const auto upper = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
      const std::uint32_t lower = upper - static_cast<std::uint32_t>(sectors) - 1;
      mesh.faces.push_back({lower - 1, lower, upper});
      if (i < rings) mesh.faces.push_back({lower - 1, upper, upper - 1});
    }
  }
  part.paint = {Material::kGrey, 0.42};
  return part;
}

void MoveObjects(const Eigen::Vector3d& by_mm, Scene& scene) {
  for (ScenePart& part : scene.parts) {
    if (!part.is_object) continue;
    for (Eigen::Vector3d& v : part.mesh.vertices) v += by_mm;
    part.moved += by_mm;
  }
}

TriangleMesh ObjectMesh(const Scene& scene) {
  TriangleMesh all;
  for (const ScenePart& part : scene.parts) {
    if (!part.is_object) continue;
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part.mesh.vertices.begin(), part.mesh.vertices.end());
    for (const auto& f : part.mesh.faces) all.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  }
  return all;
}

Eigen::AlignedBox2d VisibleRectangle(const Camera& camera, double z, double margin) {
  const double w = camera.width - 1.0, h = camera.height - 1.0;
  const auto at = [&](double u, double v) -> Eigen::Vector2d {
    const Ray ray = CastRay(camera, {u * w, v * h});
    const auto t = Intersect(ray, Plane{Eigen::Vector3d::UnitZ(), z});
    if (!t) throw std::logic_error("VisibleRectangle: the camera does not look at the plane");
    return ray.At(*t).head<2>();
  };
  const double lo = margin, hi = 1.0 - margin;
  // x grows with u and y with -v, up to the camera's small roll.
  const Eigen::Vector2d min(std::max({at(lo, lo).x(), at(lo, 0.5).x(), at(lo, hi).x()}),
                            std::max({at(lo, hi).y(), at(0.5, hi).y(), at(hi, hi).y()}));
  const Eigen::Vector2d max(std::min({at(hi, lo).x(), at(hi, 0.5).x(), at(hi, hi).x()}),
                            std::min({at(lo, lo).y(), at(0.5, lo).y(), at(hi, lo).y()}));
  return {min, max};
}

}  // namespace dorsum
