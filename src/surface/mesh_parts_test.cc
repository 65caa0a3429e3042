// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_parts.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = MeshPart::kNone;

// A square of two faces above y, and a vertex that none has.
MeshPart Square(double y) {
  MeshPart part;
  part.mesh.vertices = {
      {9.0, 9.0, 9.0}, {0.0, y, 0.0}, {1.0, y, 0.0}, {1.0, y + 1.0, 0.0}, {0.0, y + 1.0, 0.0}};
  part.mesh.faces = {{1, 2, 3}, {1, 3, 4}};
  part.first = {1, 2, kNone};
  part.last = {4, 3, 0};
  return part;
}

TEST(MeshParts, ShareTheirBorderAndLoseLooseVertices) {
  Context four;
  four.threads = 4;
  for (const Context& context : {Context(), four}) {
    const TriangleMesh mesh = JoinParts({Square(0.0), Square(1.0), Square(2.0)}, context);
    EXPECT_EQ(mesh.vertices.size(), 8U);
    ASSERT_EQ(mesh.faces.size(), 6U);
    ASSERT_EQ(mesh.normals.size(), 8U);
    double area = 0.0;
    for (const auto& f : mesh.faces) {
      const Eigen::Vector3d& a = mesh.vertices[f[0]];
      area += 0.5 * ((mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a)).z();
    }
    EXPECT_NEAR(area, 3.0, 1e-12);
    for (const Eigen::Vector3d& n : mesh.normals) EXPECT_NEAR(n.z(), 1.0, 1e-12);
    for (const Eigen::Vector3d& p : mesh.vertices) EXPECT_EQ(p.z(), 0.0);
  }
}

TEST(MeshParts, AVertexStaysThatOnlyThePartBehindUses) {
  MeshPart before = Square(0.0);
  before.mesh.faces = {{1, 2, 3}};  // the fourth vertex is the next part's alone
  const TriangleMesh mesh = JoinParts({before, Square(1.0)}, {});
  EXPECT_EQ(mesh.vertices.size(), 6U);
  for (const auto& f : mesh.faces) {
    for (const std::uint32_t i : f) EXPECT_LT(i, 6U);
  }
  EXPECT_EQ(mesh.vertices[mesh.faces[1][0]], Eigen::Vector3d(0.0, 1.0, 0.0));
}

TEST(MeshParts, NothingComesOfNothing) {
  EXPECT_TRUE(JoinParts({}, {}).faces.empty());
  EXPECT_TRUE(JoinParts({{}, {}}, {}).vertices.empty());
}

}  // namespace
}  // namespace dorsum
