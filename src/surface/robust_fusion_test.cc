// SPDX-License-Identifier: Apache-2.0
#include "surface/robust_fusion.h"

#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"

namespace dorsum {
namespace {

const double kNothing = std::nan("");

double Slab(double x, double y) {
  return std::abs(x) < 40.0 && std::abs(y) < 20.0 ? 20.0 + 0.1 * x - 0.05 * y : kNothing;
}

// Two fingers of radius 9 mm along x with round ends, 4 mm apart.
double Fingers(double x, double y) {
  const double square = std::pow(std::abs(y) - 11.0, 2) + std::pow(std::max(0.0, std::abs(x) - 31.0), 2);
  return square < 81.0 ? 10.0 + std::sqrt(81.0 - square) : kNothing;
}

struct Errors {
  double rms = 0.0, worst = 0.0;
  int known = 0, beside = 0;  // grid nodes with a height, and those of them beside the body
};

Errors Against(const HeightField& field, const BodyHeight& body) {
  Errors e;
  for (int r = 0; r < field.z.rows; ++r) {
    for (int c = 0; c < field.z.cols; ++c) {
      if (std::isnan(field.z(r, c))) continue;
      const double truth =
          body(field.origin_mm.x() + field.pitch_mm * c, field.origin_mm.y() + field.pitch_mm * r);
      ++e.known;
      if (std::isnan(truth)) {
        ++e.beside;
        continue;
      }
      e.rms += std::pow(field.z(r, c) - truth, 2);
      e.worst = std::max(e.worst, std::abs(field.z(r, c) - truth));
    }
  }
  e.rms = std::sqrt(e.rms / std::max(1, e.known - e.beside));
  return e;
}

TEST(RobustFusionTest, APlaneComesBackToItsEdges) {
  const Scene s = ScanBody(Slab);
  const RobustFusion f = FuseRobust(s.points, s.camera, s.mask, {});
  const Errors e = Against(f.field, Slab);
  EXPECT_LT(e.rms, 0.005);
  EXPECT_GT(e.known, 0.96 * 160 * 80);
  EXPECT_LT(e.beside, 0.02 * 160 * 80);  // the mask's pixels are as wide as the grid's pitch
  EXPECT_EQ(f.misplaced + f.outliers, 0);
  EXPECT_EQ(f.mesh.normals.size(), f.mesh.vertices.size());
}

TEST(RobustFusionTest, NoSkinGrowsBetweenFingersAndTheirFlanksAreRound) {
  const Scene s = ScanBody(Fingers);
  const RobustFusion f = FuseRobust(s.points, s.camera, s.mask, {});
  for (const Eigen::Vector3d& p : f.mesh.vertices) EXPECT_GT(std::abs(p.y()), 1.5);
  // Where the flank is less steep than 64 degrees.
  const Errors e =
      Against(f.field, [](double x, double y) { return Fingers(x, y) > 14.0 ? Fingers(x, y) : kNothing; });
  EXPECT_LT(e.rms, 0.06);
  EXPECT_LT(e.worst, 0.62);
}

TEST(RobustFusionTest, NoiseIsAveragedAndAStepStaysAStep) {
  const auto step = [](double x, double y) { return Slab(x, y) + (y > 3.0 ? 12.0 : 0.0); };
  Scene s = ScanBody(step, 4);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.05);
  for (SurfacePoint& p : s.points) p.position.z() += noise(random);
  const RobustFusion f = FuseRobust(s.points, s.camera, s.mask, {});
  const Errors e =
      Against(f.field, [&](double x, double y) { return std::abs(y - 3.0) > 2.0 ? step(x, y) : kNothing; });
  EXPECT_LT(e.rms, 0.04);
  EXPECT_LT(e.worst, 0.5);
}

TEST(RobustFusionTest, WrongOrdersAndSpikesAreNamedAndLeaveNoTrace) {
  Scene s = ScanBody(Slab, 4);
  std::vector<PointVerdict> expected;
  for (SurfacePoint& p : s.points) {
    const bool wrong = p.laser == 1 && p.order == 9,
               spike = p.laser == 2 && p.order == 9 && std::abs(p.v - 240.0F) < 1.5F;
    if (wrong) p.position.z() += 40.0;
    if (spike) p.position.z() += 2.8;
    expected.push_back(wrong   ? PointVerdict::kMisplaced
                       : spike ? PointVerdict::kOutlier
                               : PointVerdict::kGood);
  }
  const RobustFusion f = FuseRobust(s.points, s.camera, s.mask, {});
  EXPECT_EQ(f.verdicts, expected);
  EXPECT_GT(f.misplaced, 50);
  EXPECT_EQ(f.outliers, 3);
  EXPECT_LT(Against(f.field, Slab).worst, 0.1);
}

TEST(RobustFusionTest, AHoleStaysWhereNothingWasSeen) {
  Scene s = ScanBody(Slab);
  std::erase_if(s.points,
                [](const SurfacePoint& p) { return p.position.x() > 5.0 && p.position.x() < 33.0; });
  const HeightField field = FuseRobust(s.points, s.camera, s.mask, {}).field;
  const auto at = [&](double x) {
    return field.z(static_cast<int>(std::lround(-field.origin_mm.y() / field.pitch_mm)),
                   static_cast<int>(std::lround((x - field.origin_mm.x()) / field.pitch_mm)));
  };
  EXPECT_TRUE(std::isnan(at(19.0)));
  EXPECT_NEAR(at(7.0), Slab(7.0, 0.0), 0.05);
}

TEST(RobustFusionTest, ALasersOffsetIsReportedAndTakenOff) {
  Scene s = ScanBody(Slab, 4);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.05);
  for (SurfacePoint& p : s.points) p.position.z() += noise(random) + (p.laser == 3 ? 0.12 : 0.0);
  const RobustFusion f = FuseRobust(s.points, s.camera, s.mask, {});
  ASSERT_EQ(f.offsets.size(), 4U);
  EXPECT_NEAR(f.offsets[3].mean_mm, 0.09, 0.015);  // against the mean of all four
  EXPECT_NEAR(f.offsets[0].mean_mm, -0.03, 0.015);
  EXPECT_LT(f.offsets[3].sd_mm, 0.03);
}

TEST(RobustFusionTest, TheNumberOfThreadsDoesNotMatter) {
  const Scene s = ScanBody(Fingers);
  const RobustFusion one = FuseRobust(s.points, s.camera, s.mask, {}, WithThreads(1));
  const RobustFusion many = FuseRobust(s.points, s.camera, s.mask, {}, WithThreads(4));
  ASSERT_EQ(one.field.z.size(), many.field.z.size());
  EXPECT_EQ(std::memcmp(one.field.z.data, many.field.z.data, one.field.z.total() * sizeof(float)), 0);
  EXPECT_EQ(one.mesh.faces, many.mesh.faces);
}

TEST(RobustFusionTest, NothingGivesNothing) {
  const Scene s = ScanBody(Slab);
  EXPECT_TRUE(FuseRobust({}, s.camera, s.mask, {}).mesh.faces.empty());
  const RobustFusion outside =
      FuseRobust(s.points, s.camera, cv::Mat(s.mask.size(), CV_8UC1, cv::Scalar(0)), {});
  EXPECT_TRUE(outside.mesh.faces.empty());
  EXPECT_TRUE(outside.field.z.empty());
}

}  // namespace
}  // namespace dorsum
