// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_measure.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "studio/shapes_test.h"
#include "studio/surface_scene.h"

namespace dorsum {
namespace {

MeshPlace PlaceOn(const TriangleMesh& mesh, const Ray& ray) {
  Scan scan;
  scan.surface.mesh = mesh;
  const std::optional<Picked> picked = Pick(scan, ray, Shown::kMesh, 0.0);
  return picked ? MeshPlace{picked->position, picked->face.value_or(0)} : MeshPlace{};
}
MeshPlace Below(const TriangleMesh& mesh, double x, double y) {
  return PlaceOn(mesh, {{x, y, 300.0}, {0.0, 0.0, -1.0}});
}

// Ways along edges alone would be up to 41 % too long against the diagonals.
TEST(SurfaceMeasure, OnAPlaneTheShortestWayIsStraightInAllDirections) {
  const TriangleMesh mesh = PlaneMesh(41, 1.0, [](double, double) { return 3.0; });
  const MeshPlace from = Below(mesh, 0.21, -0.32);
  for (const double turn : {0.1, 0.8, 1.6, 2.37, 3.1, 4.0, 5.5}) {
    const MeshPlace to = Below(mesh, 0.21 + 17.0 * std::cos(turn), -0.32 + 17.0 * std::sin(turn));
    const Result<SurfaceDistance> way = MeasureAlong(mesh, from, to, {});
    ASSERT_TRUE(way.ok());
    EXPECT_NEAR(way->straight_mm, 17.0, 1e-9);
    EXPECT_NEAR(way->along_mm, 17.0, 0.02) << turn;
    EXPECT_GE(way->along_mm, way->straight_mm - 1e-9);
  }
}

TEST(SurfaceMeasure, OnASphereTheShortestWayIsAnArcOfAGreatCircle) {
  const double radius = 40.0;
  const TriangleMesh mesh = SphereMesh(radius, 90);
  const Eigen::Vector3d a = Eigen::Vector3d(0.2, 0.3, 0.9).normalized();
  for (const Eigen::Vector3d& towards :
       {Eigen::Vector3d(0.9, -0.1, 0.4), Eigen::Vector3d(-0.5, -0.6, 0.1), Eigen::Vector3d(0.3, 0.2, -0.4)}) {
    const Eigen::Vector3d b = towards.normalized();
    const Result<SurfaceDistance> way =
        MeasureAlong(mesh, PlaceOn(mesh, {100.0 * a, -a}), PlaceOn(mesh, {100.0 * b, -b}), {});
    ASSERT_TRUE(way.ok());
    const double arc = radius * std::acos(a.dot(b));
    EXPECT_NEAR(way->along_mm, arc, 0.004 * arc);
    EXPECT_NEAR(way->straight_mm, radius * (a - b).norm(), 0.1);
    for (const Eigen::Vector3d& p : way->path) EXPECT_NEAR(p.norm(), radius, 0.05);
  }
}

TEST(SurfaceMeasure, TwoPartsThatDoNotTouchHaveNoDistance) {
  TriangleMesh mesh = PlaneMesh(3, 1.0, [](double, double) { return 0.0; });
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  const TriangleMesh copy = mesh;
  for (const Eigen::Vector3d& v : copy.vertices) mesh.vertices.emplace_back(v + Eigen::Vector3d(9, 0, 0));
  for (const auto& f : copy.faces) mesh.faces.push_back({f[0] + count, f[1] + count, f[2] + count});
  const Result<SurfaceDistance> way = MeasureAlong(mesh, Below(mesh, 0.1, 0.2), Below(mesh, 9.1, 0.2), {});
  ASSERT_FALSE(way.ok());
  EXPECT_EQ(way.error().code, ErrorCode::kAnswerIsNo);
}

TEST(SurfaceMeasure, ACylinderCutAcrossIsACircle) {
  const double radius = 12.0;
  const TriangleMesh mesh =
      PlaneMesh(49, 0.5, [&](double x, double) { return std::sqrt(std::max(radius * radius - x * x, 0.0)); });
  const Result<Section> section = CutMesh(mesh, {-5.0, 1.3, 0.0}, {5.0, 1.3, 0.0});
  ASSERT_TRUE(section.ok());
  EXPECT_NEAR(section->length_mm, 10.0, 1e-12);
  ASSERT_EQ(section->curves.size(), 1U);
  const SectionCurve& curve = section->curves.front();
  EXPECT_NEAR(curve.front().x(), -7.0, 1e-9);  // the whole mesh, from the first place on
  EXPECT_NEAR(curve.back().x(), 17.0, 1e-9);
  EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end(), [](auto& l, auto& r) { return l.x() < r.x(); }));
  for (const Eigen::Vector2d& p : curve) {
    if (std::abs(p.x() - 5.0) > 10.0) continue;  // too steep for the mesh
    EXPECT_NEAR(std::hypot(p.x() - 5.0, p.y()), radius, 0.02);
  }
}

TEST(SurfaceMeasure, ASphereCutIsOneClosedCurveAndAlongVerticesToo) {
  const TriangleMesh sphere = SphereMesh(10.0, 40);
  const Result<Section> round = CutMesh(sphere, {0.05, 0.3, 0.0}, {1.0, 0.7, 0.0});
  ASSERT_TRUE(round.ok());
  ASSERT_EQ(round->curves.size(), 1U);
  EXPECT_EQ(round->curves.front().front(), round->curves.front().back());
  const TriangleMesh plane = PlaneMesh(5, 1.0, [](double, double) { return 2.0; });
  const Result<Section> row = CutMesh(plane, {-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
  ASSERT_TRUE(row.ok());
  ASSERT_EQ(row->curves.size(), 1U);
  EXPECT_NEAR(row->curves.front().back().x() - row->curves.front().front().x(), 4.0, 1e-9);
}

TEST(SurfaceMeasure, AGapInTheMeshIsAGapInTheSection) {
  TriangleMesh mesh = PlaneMesh(11, 1.0, [](double, double) { return 2.0; });
  std::erase_if(mesh.faces, [&](const auto& f) { return std::abs(mesh.vertices[f[0]].x()) < 1.0; });
  const Result<Section> section = CutMesh(mesh, {-1.0, 0.2, 0.0}, {1.0, 0.2, 0.0});
  ASSERT_TRUE(section.ok());
  EXPECT_EQ(section->curves.size(), 2U);
  EXPECT_FALSE(CutMesh(mesh, {1.0, 1.0, 0.0}, {1.0, 1.0, 9.0}).ok());
}

TEST(SurfaceMeasure, PointsAreCutWhereTheyLieNearThePlane) {
  const Result<Section> section =
      CutPoints({{3.0, 0.1, 7.0}, {1.0, -0.2, 6.0}, {2.0, 4.0, 9.0}}, {0, 0, 0}, {5, 0, 0}, 0.5);
  ASSERT_TRUE(section.ok());
  ASSERT_EQ(section->dots.size(), 2U);
  EXPECT_EQ(section->dots.front(), Eigen::Vector2d(1.0, 6.0));
}

}  // namespace
}  // namespace dorsum
