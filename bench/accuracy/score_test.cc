// SPDX-License-Identifier: Apache-2.0
#include "accuracy/score.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum::accuracy {
namespace {

constexpr double kBoxHeight = 20.0;
constexpr int kLeft = 40, kRight = 159, kTop = 30, kBottom = 119;  // the box's pixels, inclusive

// A camera straight above a box that fills a rectangle of the picture, and one laser's stripes every 10
// columns.
CaptureTruth BoxTruth() {
  CaptureTruth truth;
  truth.camera.width = 200;
  truth.camera.height = 150;
  truth.camera.fx = truth.camera.fy = 400.0;
  truth.camera.cx = 100.0;
  truth.camera.cy = 75.0;
  truth.camera.camera_from_world.rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  truth.camera.camera_from_world.translation = {0.0, 0.0, 400.0};
  truth.material = cv::Mat1b::zeros(150, 200);
  truth.xyz.create(150, 200);
  const Eigen::Vector3d centre = truth.camera.Center();
  for (int v = 0; v < 150; ++v) {
    for (int u = 0; u < 200; ++u) {
      const bool box = u >= kLeft && u <= kRight && v >= kTop && v <= kBottom;
      if (box) truth.material(v, u) = 3;
      const Eigen::Vector3d d = CastRay(truth.camera, Eigen::Vector2d(u, v)).direction;
      const Eigen::Vector3d p = centre + ((box ? kBoxHeight : 0.0) - centre.z()) / d.z() * d;
      truth.xyz(v, u) = {p.x(), p.y(), p.z()};
    }
  }
  for (int v = kTop; v < kBottom; ++v) {  // the last row has half its neighbours beside the box
    for (int u = 45; u < kRight; u += 10)
      truth.lasers[0].push_back({u / 10, v, u + 0.25, kBoxHeight, 3, 0.5});
  }
  return truth;
}

SurfacePoint PointAt(const CaptureTruth& truth, double u, int v, double z, int order) {
  SurfacePoint p;
  const Ray ray = CastRay(truth.camera, Eigen::Vector2d(u, v));
  p.position = ray.At((z - ray.origin.z()) / ray.direction.z());
  p.u = static_cast<float>(u);
  p.v = static_cast<float>(v);
  p.order = static_cast<std::int16_t>(order);
  p.sigma = 0.1F;
  return p;
}

// A point on every true stripe, at the true height.
SurfacePoints PerfectPoints(const CaptureTruth& truth) {
  SurfacePoints points;
  for (const TrueStripe& s : truth.lasers.at(0)) points.push_back(PointAt(truth, s.u, s.row, s.z, s.order));
  return points;
}

TEST(ScoreTest, PerfectPointsScorePerfectly) {
  const CaptureTruth truth = BoxTruth();
  const auto score = ScorePoints(truth, PerfectPoints(truth));
  ASSERT_TRUE(score);
  EXPECT_LT(score->z.rmse, 1e-5);
  EXPECT_LT(score->xy_rmse, 1e-5);
  EXPECT_EQ(score->wrong, 0.0);
  EXPECT_EQ(score->complete, 1.0);
  EXPECT_EQ(score->stray, 0.0);
  EXPECT_EQ(score->beyond, 0.0);
}

TEST(ScoreTest, ErrorsAreOfHeightAtThePointsPixelAndTheirSigmaIsJudged) {
  const CaptureTruth truth = BoxTruth();
  SurfacePoints points = PerfectPoints(truth);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].position.z() += i % 2 == 0 ? 0.3 : -0.1;
  const auto score = ScorePoints(truth, points);
  ASSERT_TRUE(score);
  EXPECT_NEAR(score->z.bias, 0.1, 1e-4);
  EXPECT_NEAR(score->z.rmse, std::sqrt(0.05), 1e-4);
  EXPECT_NEAR(score->z.p95_abs, 0.3, 1e-4);
  ASSERT_TRUE(score->sigma_ratio);
  EXPECT_NEAR(*score->sigma_ratio, 10.0 * std::sqrt(0.05), 1e-3);
  EXPECT_NEAR(score->z_rmse_laser.at(0), score->z.rmse, 1e-12);
}

TEST(ScoreTest, AWrongOrderIsWrongAndNotFound) {
  const CaptureTruth truth = BoxTruth();
  SurfacePoints points = PerfectPoints(truth);
  const std::size_t tenth = points.size() / 10;
  for (std::size_t i = 0; i < tenth; ++i) points[i].position.z() += 35.0;
  const auto score = ScorePoints(truth, points);
  ASSERT_TRUE(score);
  const double share = static_cast<double>(tenth) / static_cast<double>(points.size());
  EXPECT_NEAR(score->wrong, share, 1e-12);
  EXPECT_NEAR(score->complete, 1.0 - share, 1e-12);
  EXPECT_LT(score->z_rmse_right, 1e-5);
  EXPECT_EQ(score->stray, 0.0);  // there is a stripe, only not of that order
}

TEST(ScoreTest, PointsBetweenStripesAreStrayAndPointsBesideTheObjectBeyond) {
  const CaptureTruth truth = BoxTruth();
  SurfacePoints points = PerfectPoints(truth);
  const auto real = static_cast<double>(points.size());
  for (int v = 40; v < 60; ++v) points.push_back(PointAt(truth, 50.0, v, kBoxHeight, 0));
  for (int v = 40; v < 50; ++v) points.push_back(PointAt(truth, 20.0, v, 0.0, 0));
  points.push_back(PointAt(truth, kLeft - 2.0, 40, kBoxHeight, 0));  // the outline's own uncertainty
  const auto score = ScorePoints(truth, points);
  ASSERT_TRUE(score);
  EXPECT_NEAR(score->stray, 20.0 / (real + 20.0), 1e-12);
  EXPECT_NEAR(score->beyond, 10.0 / (real + 31.0), 1e-12);
  EXPECT_EQ(score->points_on_object, static_cast<int>(real) + 20);
}

TEST(ScoreTest, AnotherWorldFrameInThePlaneCostsNothing) {
  const CaptureTruth truth = BoxTruth();
  SurfacePoints points = PerfectPoints(truth);
  const double angle = 0.2;
  for (SurfacePoint& p : points) {
    const double x = p.position.x(), y = p.position.y();
    p.position.x() = std::cos(angle) * x - std::sin(angle) * y + 3.0;
    p.position.y() = std::sin(angle) * x + std::cos(angle) * y - 1.0;
  }
  const auto score = ScorePoints(truth, points);
  ASSERT_TRUE(score);
  EXPECT_LT(score->xy_rmse, 1e-5);
  EXPECT_NEAR(score->alignment.rotation(0, 1), std::sin(angle), 1e-6);
}

TEST(ScoreTest, TooFewPointsGiveNoScore) {
  const CaptureTruth truth = BoxTruth();
  SurfacePoints points = PerfectPoints(truth);
  points.resize(49);
  EXPECT_FALSE(ScorePoints(truth, points));
}

// A square of the box's top between two columns and two rows, as a mesh of two triangles for each 4 px.
TriangleMesh TopMesh(const CaptureTruth& truth, int left, int right, int top, int bottom, double z) {
  TriangleMesh mesh;
  const int columns = (right - left) / 4 + 1;
  for (int v = top; v <= bottom; v += 4) {
    for (int u = left; u <= right; u += 4) mesh.vertices.push_back(PointAt(truth, u, v, z, 0).position);
  }
  const auto rows = static_cast<int>(mesh.vertices.size()) / columns;
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < columns; ++c) {
      const auto i = static_cast<std::uint32_t>(r * columns + c),
                 below = i + static_cast<std::uint32_t>(columns);
      mesh.faces.push_back({i, i + 1, below});
      mesh.faces.push_back({i + 1, below + 1, below});
    }
  }
  return mesh;
}

TEST(ScoreTest, ASurfaceIsJudgedWhereItLiesAndByWhatItCovers) {
  const CaptureTruth truth = BoxTruth();
  const auto half =
      ScoreSurface(truth, TopMesh(truth, kLeft, kLeft + 60, kTop, kBottom - 1, kBoxHeight + 0.25), {});
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->z.bias, 0.25, 1e-9);
  EXPECT_NEAR(half->z.rmse, 0.25, 1e-9);
  EXPECT_EQ(half->wrong, 0.0);
  EXPECT_NEAR(half->cover, 0.5, 0.02);
  EXPECT_EQ(half->beyond, 0.0);

  const auto wide =
      ScoreSurface(truth, TopMesh(truth, kLeft - 20, kRight + 1, kTop, kBottom - 1, kBoxHeight), {});
  ASSERT_TRUE(wide);
  EXPECT_GT(wide->cover, 0.97);
  EXPECT_NEAR(wide->beyond, 17.0 / 120.0, 0.02);
}

TEST(ScoreTest, FiguresCarryTheNamesOfTheTables) {
  const CaptureTruth truth = BoxTruth();
  const auto points = ScorePoints(truth, PerfectPoints(truth));
  const auto surface = ScoreSurface(truth, TopMesh(truth, kLeft, kRight, kTop, kBottom, kBoxHeight), {});
  const Figures figures = ToFigures(*points, surface);
  for (const char* name : {"z_rmse", "wrong", "complete", "stray", "beyond", "xy_rmse", "sigma_ratio",
                           "z_rmse_laser0", "surface_z_rmse", "surface_z_median_abs", "surface_z_p95_abs",
                           "surface_wrong", "surface_cover", "surface_beyond"}) {
    EXPECT_EQ(figures.count(name), 1U) << name;
  }
}

}  // namespace
}  // namespace dorsum::accuracy
