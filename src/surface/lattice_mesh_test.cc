// SPDX-License-Identifier: Apache-2.0
#include "surface/lattice_mesh.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "surface/fusion_scene_test.h"
#include "surface/mesh_raster.h"

namespace dorsum {
namespace {

class LatticeMeshTest : public ::testing::Test {
 protected:
  LatticeMeshTest() : mask_(480, 640, CV_8UC1, cv::Scalar(0)), rays_(TestCamera(), cv::Rect(0, 0, 640, 480)) {
    cv::circle(mask_, {320, 240}, 100, cv::Scalar(255), cv::FILLED);
    lattice_ = FullLattice(128, 96, 5.0, 1.0F);
    lattice_.z.setTo(10.0F);
  }
  cv::Mat mask_;
  RayField rays_;
  PlateLattice lattice_;
};

TEST_F(LatticeMeshTest, TheMeshEndsAtTheOutline) {
  const TriangleMesh mesh = MeshLattice(lattice_, Outline(mask_, 10), rays_, 80.0);
  double area = 0.0;
  for (const auto& f : mesh.faces) {
    const Eigen::Vector3d& a = mesh.vertices[f[0]];
    const Eigen::Vector3d normal = (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a);
    EXPECT_GE(normal.z(), 0.0);
    area += 0.5 * normal.norm();
  }
  const double mm_per_px = 390.0 / 800.0;
  EXPECT_NEAR(area / (std::numbers::pi * std::pow(100.5 * mm_per_px, 2)), 1.0, 0.01);
  for (const Eigen::Vector3d& p : mesh.vertices) EXPECT_LT(p.head<2>().norm(), 101.5 * mm_per_px);
  ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
  for (const Eigen::Vector3d& n : mesh.normals) EXPECT_NEAR(n.z(), 1.0, 1e-6);
}

TEST_F(LatticeMeshTest, AJumpStaysOpen) {
  for (int r = 0; r < 96; ++r) {
    for (int c = 64; c < 128; ++c) lattice_.z(r, c) = 40.0F;
  }
  const TriangleMesh mesh = MeshLattice(lattice_, Outline(mask_, 10), rays_, 80.0);
  for (const auto& f : mesh.faces) {
    EXPECT_EQ(mesh.vertices[f[0]].z(), mesh.vertices[f[1]].z());
    EXPECT_EQ(mesh.vertices[f[0]].z(), mesh.vertices[f[2]].z());
  }
}

TEST_F(LatticeMeshTest, HeightsOnTheGridAreTheMeshs) {
  for (int r = 0; r < 96; ++r) {
    for (int c = 0; c < 128; ++c) lattice_.z(r, c) = 10.0F + 0.1F * static_cast<float>(c);
  }
  const TriangleMesh mesh = MeshLattice(lattice_, Outline(mask_, 10), rays_, 80.0);
  const HeightField field = RasterizeMesh(mesh, 0.5);
  EXPECT_NEAR(std::remainder(field.origin_mm.x(), 0.5), 0.0, 1e-9);
  int known = 0;
  for (int r = 0; r < field.z.rows; ++r) {
    for (int c = 0; c < field.z.cols; ++c) {
      if (std::isnan(field.z(r, c))) continue;
      const Eigen::Vector2d xy = field.origin_mm + 0.5 * Eigen::Vector2d(c, r);
      const double u = Project(TestCamera(), {xy.x(), xy.y(), field.z(r, c)}).x();
      EXPECT_NEAR(field.z(r, c), 10.0 + 0.02 * u, 0.002);
      ++known;
    }
  }
  EXPECT_NEAR(known * 0.25 / (std::numbers::pi * 48.3 * 48.3), 1.0, 0.03);
  EXPECT_TRUE(RasterizeMesh({}, 0.5).z.empty());
}

}  // namespace
}  // namespace dorsum
