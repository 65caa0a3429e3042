// SPDX-License-Identifier: Apache-2.0
#include "surface/height_mesh.h"

#include <cmath>
#include <functional>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

constexpr int kRows = 12, kColumns = 20;

HeightField Field(const std::function<double(int row, int column)>& z) {
  HeightField field;
  field.origin_mm = {-3.0, 7.0};
  field.pitch_mm = 0.5;
  field.z = cv::Mat1f(kRows, kColumns);
  for (int r = 0; r < kRows; ++r) {
    for (int c = 0; c < kColumns; ++c) field.z(r, c) = static_cast<float>(z(r, c));
  }
  return field;
}

Eigen::Vector3d FaceNormal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& f) {
  const Eigen::Vector3d& a = mesh.vertices[f[0]];
  return (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a);
}

TEST(HeightMesh, AFullFieldIsCoveredOnceWithFacesUp) {
  const TriangleMesh mesh = MeshHeightField(Field([](int r, int c) { return 5.0 + 0.1 * c - 0.05 * r; }));
  EXPECT_EQ(mesh.vertices.size(), static_cast<std::size_t>(kRows * kColumns));
  EXPECT_EQ(mesh.faces.size(), static_cast<std::size_t>(2 * (kRows - 1) * (kColumns - 1)));
  double area = 0.0;
  for (const auto& f : mesh.faces) {
    const Eigen::Vector3d n = FaceNormal(mesh, f);
    EXPECT_GT(n.z(), 0.0);
    area += 0.5 * n.z();
  }
  EXPECT_NEAR(area, 0.25 * (kRows - 1) * (kColumns - 1), 1e-9);
  EXPECT_LT((mesh.vertices.front() - Eigen::Vector3d(-3.0, 7.0, 5.0)).norm(), 1e-6);
}

TEST(HeightMesh, NormalsOfAPlaneAreThePlanes) {
  const TriangleMesh mesh = MeshHeightField(Field([](int r, int c) { return 0.1 * c - 0.05 * r; }));
  const Eigen::Vector3d expected = Eigen::Vector3d(-0.2, 0.1, 1.0).normalized();
  ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
  for (const Eigen::Vector3d& n : mesh.normals) EXPECT_LT((n - expected).norm(), 1e-5);
}

TEST(HeightMesh, AJumpAndAHoleStayOpen) {
  const TriangleMesh mesh = MeshHeightField(Field([](int r, int c) {
    if (r == 5 && c == 3) return std::nan("");
    return c < 10 ? 5.0 : 15.0;
  }));
  // One column of cells is left out at the jump, and the six triangles around the hole.
  EXPECT_EQ(mesh.faces.size(), static_cast<std::size_t>(2 * (kRows - 1) * (kColumns - 2) - 6));
  for (const auto& f : mesh.faces) {
    const std::set<double> heights{mesh.vertices[f[0]].z(), mesh.vertices[f[1]].z(), mesh.vertices[f[2]].z()};
    EXPECT_EQ(heights.size(), 1U);
  }
}

TEST(HeightMesh, VerticesWithoutATriangleAreLeftOut) {
  const TriangleMesh mesh =
      MeshHeightField(Field([](int r, int c) { return r == 5 && c > 2 ? 1.0 : std::nan(""); }));
  EXPECT_TRUE(mesh.faces.empty());
  EXPECT_TRUE(mesh.vertices.empty());
  EXPECT_TRUE(MeshHeightField(HeightField{}).vertices.empty());
}

TEST(HeightMesh, PointsGetTheNormalOfTheSurfaceNearThem) {
  const TriangleMesh mesh = MeshHeightField(Field([](int r, int c) { return 0.1 * c - 0.05 * r; }));
  SurfacePoints points(2);
  points[0].position = mesh.vertices[45] + Eigen::Vector3d(0.05, 0.02, 0.1);
  points[1].position = {500.0, 0.0, 0.0};
  AssignNormals(mesh, 1.0, &points);
  EXPECT_LT((points[0].normal.cast<double>() - mesh.normals[45]).norm(), 1e-6);
  EXPECT_EQ(points[1].normal, Eigen::Vector3f::UnitZ());
  AssignNormals(TriangleMesh{}, 1.0, &points);
  EXPECT_LT((points[0].normal.cast<double>() - mesh.normals[45]).norm(), 1e-6);
}

}  // namespace
}  // namespace dorsum
