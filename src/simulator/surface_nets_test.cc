// SPDX-License-Identifier: Apache-2.0
#include "simulator/surface_nets.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

double Ball(const Eigen::Vector3d& p) { return (p - Eigen::Vector3d(0.3, -0.2, 0.1)).norm() - 5.0; }

SurfaceNetsOptions Box(double cell) {
  SurfaceNetsOptions options;
  options.lo.setConstant(-7);
  options.hi.setConstant(7);
  options.cell = cell;
  return options;
}

double Volume(const TriangleMesh& mesh) {
  double six = 0;
  for (const auto& f : mesh.faces) {
    six += mesh.vertices[f[0]].dot(mesh.vertices[f[1]].cross(mesh.vertices[f[2]]));
  }
  return six / 6;
}

TEST(SurfaceNetsTest, BallIsRound) {
  const TriangleMesh mesh = SurfaceNets(Ball, Box(0.5));
  ASSERT_GT(mesh.vertices.size(), 500u);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    EXPECT_NEAR(Ball(mesh.vertices[v]), 0, 1e-6);
    const Eigen::Vector3d out = (mesh.vertices[v] - Eigen::Vector3d(0.3, -0.2, 0.1)).normalized();
    EXPECT_GT(mesh.normals[v].dot(out), 0.99999);
  }
  EXPECT_NEAR(Volume(mesh), 4.0 / 3.0 * std::acos(-1.0) * 125, 0.01 * 523);  // positive: faces turn outwards
}

TEST(SurfaceNetsTest, EachEdgeJoinsTwoFacesTheOtherWayRound) {
  const TriangleMesh mesh = SurfaceNets(Ball, Box(0.7));
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& f : mesh.faces) {
    for (int k = 0; k < 3; ++k) ++edges[{f[k], f[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size() / 2) +
                static_cast<long>(mesh.faces.size()),
            2);  // Euler: a sphere
}

TEST(SurfaceNetsTest, SkippingFarBlocksChangesNothing) {
  SurfaceNetsOptions all = Box(0.6);
  all.steepness = 1e6;
  const TriangleMesh skipped = SurfaceNets(Ball, Box(0.6)), full = SurfaceNets(Ball, all);
  ASSERT_EQ(skipped.vertices.size(), full.vertices.size());
  for (std::size_t v = 0; v < full.vertices.size(); ++v) EXPECT_EQ(skipped.vertices[v], full.vertices[v]);
  EXPECT_EQ(skipped.faces, full.faces);
}

TEST(SurfaceNetsTest, RefusesAnEmptyBox) {
  SurfaceNetsOptions options;
  EXPECT_THROW(SurfaceNets(Ball, options), std::logic_error);
}

}  // namespace
}  // namespace dorsum
