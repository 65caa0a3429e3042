// SPDX-License-Identifier: Apache-2.0
#include "surface/height_field.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

Context WithThreads(int threads) {
  Context context;
  context.threads = threads;
  return context;
}

using Surface = std::function<double(double x, double y)>;

// Points every 0.3 mm along stripes 4 mm apart that lean a little, over 60 x 40 mm.
SurfacePoints Scan(const Surface& z, std::uint8_t laser = 0, double shift = 0.0) {
  SurfacePoints points;
  for (int stripe = 0; stripe <= 15; ++stripe) {
    for (double y = -20.0; y <= 20.0; y += 0.3) {
      SurfacePoint p;
      const double x = -30.0 + 4.0 * stripe + 0.05 * y + shift;
      p.position = {x, y, z(x, y)};
      p.laser = laser;
      p.segment = stripe;
      points.push_back(p);
    }
  }
  return points;
}

double Tilted(double x, double y) { return 20.0 + 0.15 * x - 0.1 * y; }

float At(const HeightField& field, double x, double y) {
  const auto c = static_cast<int>(std::lround((x - field.origin_mm.x()) / field.pitch_mm));
  const auto r = static_cast<int>(std::lround((y - field.origin_mm.y()) / field.pitch_mm));
  if (r < 0 || c < 0 || r >= field.z.rows || c >= field.z.cols) return std::nanf("");
  return field.z(r, c);
}

class HeightFieldTest : public ::testing::Test {
 protected:
  HeightField Fuse(const SurfacePoints& points, const HeightFieldOptions& options = {}) {
    return FuseHeightField(points, camera_, mask_, options);
  }
  Camera camera_ = TestCamera();
  cv::Mat mask_ = cv::Mat(480, 640, CV_8UC1, cv::Scalar(255));
};

TEST_F(HeightFieldTest, ATiltedPlaneComesBack) {
  SurfacePoints points = Scan(Tilted);
  const SurfacePoints second = Scan(Tilted, 1, 1.7);
  points.insert(points.end(), second.begin(), second.end());
  const HeightField field = Fuse(points);
  int known = 0;
  double square = 0.0;
  for (int r = 0; r < field.z.rows; ++r) {
    for (int c = 0; c < field.z.cols; ++c) {
      if (std::isnan(field.z(r, c))) continue;
      const Eigen::Vector2d xy = field.origin_mm + field.pitch_mm * Eigen::Vector2d(c, r);
      const double error = field.z(r, c) - Tilted(xy.x(), xy.y());
      // A crossing is the mean of the points within half a pitch of the grid row.
      EXPECT_LT(std::abs(error), 0.02);
      square += error * error;
      ++known;
    }
  }
  EXPECT_GT(known, 115 * 78);
  EXPECT_LT(std::sqrt(square / known), 0.01);
  EXPECT_EQ(field.left_out, 0);
}

TEST_F(HeightFieldTest, TheGridsOfTwoScansCoincide) {
  const HeightField field = Fuse(Scan(Tilted)), shifted = Fuse(Scan(Tilted, 0, 0.37));
  for (const HeightField& f : {field, shifted}) {
    EXPECT_NEAR(std::remainder(f.origin_mm.x(), f.pitch_mm), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(f.origin_mm.y(), f.pitch_mm), 0.0, 1e-9);
  }
}

TEST_F(HeightFieldTest, ADepthJumpIsNotBridged) {
  const HeightField field = Fuse(Scan([](double x, double) { return x < 0.0 ? 10.0 : 40.0; }));
  EXPECT_NEAR(At(field, -10.0, 0.0), 10.0, 1e-3);
  EXPECT_NEAR(At(field, 10.0, 0.0), 40.0, 1e-3);
  int between = 0;
  for (int r = 0; r < field.z.rows; ++r) {
    for (int c = 0; c < field.z.cols; ++c) between += field.z(r, c) > 10.5F && field.z(r, c) < 39.5F ? 1 : 0;
  }
  EXPECT_EQ(between, 0);
}

TEST_F(HeightFieldTest, AGapBetweenStripesThatIsTooWideStaysOpen) {
  SurfacePoints points = Scan(Tilted);
  std::erase_if(points, [](const SurfacePoint& p) { return p.segment == 7 || p.segment == 8; });  // 12 mm
  EXPECT_TRUE(std::isnan(At(Fuse(points, {.max_gap_mm = 11.0}), 0.0, 0.0)));
  EXPECT_NEAR(At(Fuse(points, {.max_gap_mm = 13.0}), 0.0, 0.0), Tilted(0.0, 0.0), 0.02);
}

TEST_F(HeightFieldTest, OutsideTheMaskNothingIsFilled) {
  // The camera sees nothing of the object right of its axis.
  mask_.colRange(320, 640).setTo(0);
  const HeightField field = Fuse(Scan(Tilted));
  EXPECT_FALSE(std::isnan(At(field, -5.0, 0.0)));
  for (double x = 1.0; x < 30.0; x += 1.0) EXPECT_TRUE(std::isnan(At(field, x, 0.0)));
}

TEST_F(HeightFieldTest, AnOutlierIsLeftOutAndCounted) {
  SurfacePoints points = Scan([](double, double) { return 20.0; });
  // A short piece of one stripe with a wrong order.
  for (SurfacePoint& p : points) {
    if (p.segment == 6 && std::abs(p.position.y()) < 0.25) p.position.z() += 15.0;
  }
  const HeightField field = Fuse(points);
  EXPECT_GE(field.left_out, 1);
  for (int r = 0; r < field.z.rows; ++r) {
    for (int c = 0; c < field.z.cols; ++c) {
      if (std::isnan(field.z(r, c))) continue;
      EXPECT_NEAR(field.z(r, c), 20.0, 1e-3);
    }
  }
  EXPECT_FALSE(std::isnan(At(field, -6.0, 0.0))) << "its neighbours close the hole";
}

TEST_F(HeightFieldTest, NoPointsOrPointsFarAwayGiveNoField) {
  EXPECT_TRUE(Fuse({}).z.empty());
  SurfacePoint far;
  far.position = {1e6, 0.0, 10.0};
  EXPECT_TRUE(Fuse({far}).z.empty());
  SurfacePoints points = Scan(Tilted);
  points.push_back(far);
  const HeightField field = Fuse(points);
  EXPECT_LT(field.z.cols, 200);
  EXPECT_NEAR(At(field, 0.0, 0.0), Tilted(0.0, 0.0), 0.02);
}

TEST_F(HeightFieldTest, TheSameBytesComeWithOneThreadAndWithMany) {
  const HeightField one = FuseHeightField(Scan(Tilted), camera_, mask_, {}, WithThreads(1));
  const HeightField many = FuseHeightField(Scan(Tilted), camera_, mask_, {}, WithThreads(4));
  ASSERT_EQ(one.z.size(), many.z.size());
  EXPECT_TRUE(std::equal(one.z.datastart, one.z.dataend, many.z.datastart));
}

}  // namespace
}  // namespace dorsum
