// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_height.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

TriangleMesh Grid(int n, double spacing, double (*z)(double, double)) {
  TriangleMesh mesh;
  for (int r = 0; r <= n; ++r) {
    for (int c = 0; c <= n; ++c) {
      const double x = spacing * (c - 0.5 * n), y = spacing * (r - 0.5 * n);
      mesh.vertices.emplace_back(x, y, z(x, y));
    }
  }
  const auto at = [n](int r, int c) { return static_cast<std::uint32_t>(r * (n + 1) + c); };
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      mesh.faces.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
      mesh.faces.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
    }
  }
  return mesh;
}

double Slope(double x, double y) { return 5.0 + 0.5 * x - 0.25 * y; }

TEST(MeshHeightTest, APlaneIsFoundEverywhereOnIt) {
  const TriangleMesh mesh = Grid(20, 1.7, Slope);
  const MeshHeight height(mesh);
  Rng rng(1);
  for (int i = 0; i < 2000; ++i) {
    const double x = rng.Uniform(-17.0, 17.0), y = rng.Uniform(-17.0, 17.0);
    const auto z = height.At(x, y);
    ASSERT_TRUE(z) << x << ", " << y;
    EXPECT_NEAR(*z, Slope(x, y), 1e-9);
  }
}

TEST(MeshHeightTest, NoGapAtEdgesVerticesAndCellBorders) {
  const TriangleMesh mesh = Grid(10, 2.0, Slope);  // cells of 2 mm meet where vertices lie
  const MeshHeight height(mesh);
  for (const auto& v : mesh.vertices) {
    const auto z = height.At(v.x(), v.y());
    ASSERT_TRUE(z) << v.transpose();
    EXPECT_NEAR(*z, v.z(), 1e-6);
  }
}

TEST(MeshHeightTest, TheHighestOfSeveralLayersCounts) {
  TriangleMesh mesh = Grid(4, 5.0, [](double, double) { return 1.0; });
  const TriangleMesh upper = Grid(2, 5.0, [](double, double) { return 8.0; });
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), upper.vertices.begin(), upper.vertices.end());
  for (const auto& f : upper.faces) mesh.faces.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
  const MeshHeight height(mesh);
  EXPECT_DOUBLE_EQ(height.At(1.0, 1.0).value_or(0.0), 8.0);
  EXPECT_DOUBLE_EQ(height.At(8.0, 8.0).value_or(0.0), 1.0);
}

TEST(MeshHeightTest, NothingBesideTheMesh) {
  const TriangleMesh mesh = Grid(4, 5.0, Slope);
  const MeshHeight height(mesh);
  for (const double far : {10.1, 1e6, 1e300, std::nan("")}) {
    EXPECT_FALSE(height.At(far, 0.0)) << far;
    EXPECT_FALSE(height.At(0.0, -far)) << far;
  }
  const TriangleMesh empty;
  EXPECT_FALSE(MeshHeight(empty).At(0.0, 0.0));
}

TEST(MeshHeightTest, AWallSeenEdgeOnIsPassedOver) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {5, 0, 30}};
  mesh.faces = {{0, 1, 2}};
  EXPECT_FALSE(MeshHeight(mesh).At(5.0, 0.0));
}

TEST(MeshHeightTest, AMeshOfKilometresDoesNotEatTheMemory) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1e7, 0, 0}, {0, 1e7, 1e7}};
  mesh.faces = {{0, 1, 2}};
  EXPECT_NEAR(MeshHeight(mesh).At(1e6, 2e6).value_or(0.0), 2e6, 1.0);
}

}  // namespace
}  // namespace dorsum
