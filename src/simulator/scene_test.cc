// SPDX-License-Identifier: Apache-2.0
#include "simulator/scene.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "simulator/board.h"
#include "simulator/scene_tracer.h"

namespace dorsum {
namespace {

// Six times the signed volume between the faces and the origin: positive where faces turn outwards.
double SignedVolume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& f : mesh.faces) {
    sum += mesh.vertices[f[0]].dot(mesh.vertices[f[1]].cross(mesh.vertices[f[2]]));
  }
  return sum / 6.0;
}

Ray Down(double x, double y) { return {{x, y, 300.0}, -Eigen::Vector3d::UnitZ()}; }

TEST(Scene, FacesTurnOutwards) {
  const BoxPlace box{{0.0, 0.0}, {40.0, 30.0}, 20.0, 0.3};
  EXPECT_NEAR(SignedVolume(BrownBox(box).mesh), 40.0 * 30.0 * 20.0, 1e-6);  // the open floor lies in z = 0
  EXPECT_NEAR(SignedVolume(WhitePlate(Rigid3{}, {50.0, 40.0}, 2.0).mesh), 50.0 * 40.0 * 2.0, 1e-6);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(SignedVolume(LyingCylinder(10.0, 60.0, {5.0, 3.0}, 0.2).mesh), pi * 100.0 * 60.0, 3.0);
  EXPECT_NEAR(SignedVolume(HalfSphere(25.0, {0.0, 0.0}).mesh), 2.0 / 3.0 * pi * 15625.0, 5.0);
}

TEST(Scene, RoundShapesAreWithinAThousandthOfAMillimetre) {
  Scene scene;
  scene.parts = {Backplane(), HalfSphere(25.0, {-40.0, 7.0}), LyingCylinder(10.0, 80.0, {50.0, -3.0}, 0.0)};
  const SceneTracer tracer(scene);
  for (double d = -8.0; d <= 8.0; d += 0.37) {
    const auto sphere = tracer.Trace(Down(-40.0 + d, 7.0 + 0.9 * d));
    ASSERT_TRUE(sphere && sphere->part == 1);
    EXPECT_NEAR((sphere->position - Eigen::Vector3d(-40.0, 7.0, 0.0)).norm(), 25.0, 0.0011);
    EXPECT_GT(sphere->normal.dot((sphere->position - Eigen::Vector3d(-40.0, 7.0, 0.0)).normalized()),
              1.0 - 1e-7);
    const auto cylinder = tracer.Trace(Down(50.0 + 3.0 * d, -3.0 + d));
    ASSERT_TRUE(cylinder && cylinder->part == 2);
    EXPECT_NEAR(std::hypot(d, cylinder->position.z() - 10.0), 10.0, 0.0011);
  }
}

TEST(Scene, FlatFacesAreExact) {
  Scene scene;
  scene.parts = {Backplane(), BrownBox({{0.0, 0.0}, {80.0, 60.0}, 25.5, 0.1})};
  const SceneTracer tracer(scene);
  const Eigen::Vector3d eye(-118.0, 3.0, 386.0);
  for (double x = -30.0; x <= 30.0; x += 3.1) {
    const Eigen::Vector3d aim(x, 0.4 * x, 25.5);
    const auto top = tracer.Trace({eye, (aim - eye).normalized()});
    ASSERT_TRUE(top && top->part == 1);
    EXPECT_LT((top->position - aim).norm(), 1e-9);
    const Eigen::Vector3d floor(x + 150.0, x, 0.0);
    const auto plane = tracer.Trace({eye, (floor - eye).normalized()});
    ASSERT_TRUE(plane && plane->part == 0);
    EXPECT_LT((plane->position - floor).norm(), 1e-9);
  }
}

TEST(Scene, PrintedEdgesLieWhereTheBoardSaysWithoutSteps) {
  // Sum the board's darkness over pixels of 0.3 mm: the black area of a square must not depend on how the
  // pixels fall on its edges.
  const BoardDesign board;
  ScenePart paper = Backplane();
  paper.mottle = 0.0;
  LayChessboard(board, Rigid3{}, paper);
  constexpr double kPixel = 0.3;
  for (const double shift : {0.0, 0.07, 0.15, 0.23}) {
    double dark = 0.0;
    for (int i = 0; i < 200; ++i) {
      const Paint paint = paper.pattern({shift + i * kPixel, 3.0, 0.0}, kPixel);
      dark += (0.82 - paint.albedo) / (0.82 - 0.045) * kPixel;
    }
    EXPECT_NEAR(dark, 30.0, 1e-6) << "four squares, two of them black";
  }
}

TEST(Scene, BoardHasTheCornersThatSetupNames) {
  const BoardDesign board;  // 11 x 8 inner corners: 12 x 9 squares around the origin
  ScenePart paper = Backplane();
  LayChessboard(board, Rigid3{}, paper);
  const auto black = [&](double x, double y) {
    return paper.pattern({x * board.square_mm, y * board.square_mm, 0.0}, 0.1).material ==
           Material::kBoardBlack;
  };
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 9; ++j) EXPECT_EQ(black(i - 5.5, j - 4.0), (i + j) % 2 == 0) << i << " " << j;
  }
  EXPECT_FALSE(black(-6.2, -4.0));
  EXPECT_FALSE(black(-5.5, -4.7));
  EXPECT_EQ(paper.pattern({300.0, 0.0, 0.0}, 0.1).material, Material::kBackplane);
}

}  // namespace
}  // namespace dorsum
