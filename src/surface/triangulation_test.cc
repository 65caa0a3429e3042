// SPDX-License-Identifier: Apache-2.0
#include "surface/triangulation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

Context WithThreads(int threads) {
  Context context;
  context.threads = threads;
  return context;
}

double Surface(double y) { return 20.0 + 0.1 * y; }

// A stripe of an order on a surface whose height depends on y alone; its points are exact.
void AddStripe(const DeviceGeometry& device, const PlaneSheet& sheet, std::optional<int> order,
               LaserStripes* stripes, std::vector<Eigen::Vector3d>* truth) {
  StripeSegment s;
  s.first = static_cast<std::int32_t>(stripes->points.size());
  s.count = 20;
  s.order = order;
  for (int i = 0; i < 20; ++i) {
    const double y = -30.0 + 3.0 * i;
    const Eigen::Vector3d p = OnSheet(sheet, y, Surface(y));
    const Eigen::Vector2d pixel = Project(device.camera, p);
    StripePoint point;
    point.u = static_cast<float>(pixel.x());
    point.v = static_cast<float>(pixel.y());
    point.sd_px = 0.1F;
    point.segment = static_cast<std::int32_t>(stripes->segments.size());
    stripes->points.push_back(point);
    truth->push_back(p);
  }
  stripes->segments.push_back(s);
}

class TriangulationTest : public ::testing::Test {
 protected:
  TriangulationTest() {
    stripes_.lasers.resize(1);
    stripes_.lasers[0].laser = 1;
    for (const int m : {-10, -3, 0, 4}) {
      AddStripe(device_, *device_.lasers[1].FindPlane(m), m, stripes_.lasers.data(), &truth_);
    }
  }
  DeviceGeometry device_ = TestDevice();
  IndexedStripes stripes_;
  std::vector<Eigen::Vector3d> truth_;
};

TEST_F(TriangulationTest, RaysMeetTheSheetsWhereTheLightIs) {
  const Triangulation t = Triangulate(stripes_, DeviceOrders(device_), {});
  ASSERT_EQ(t.points.size(), truth_.size());
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    EXPECT_LT((t.points[i].position - truth_[i]).norm(), 2e-3);  // u and v are single precision
    EXPECT_EQ(t.points[i].laser, 1);
    EXPECT_EQ(t.points[i].u, stripes_.lasers[0].points[i].u);
  }
  EXPECT_EQ(t.points[0].order, -10);
  EXPECT_EQ(t.without_order, 0);
  EXPECT_EQ(t.without_sheet, 0);
}

TEST_F(TriangulationTest, ARowsOwnHeightComesWithItsOwnDeviation) {
  const Triangulation plain = Triangulate(stripes_, DeviceOrders(device_), {});
  EXPECT_EQ(plain.points[3].row_sigma, 0.0F);
  StripePoint& p = stripes_.lasers[0].points[3];
  p.row_u = p.u + 0.5F;
  p.row_sd_px = 2.0F * p.sd_px;
  const Triangulation pooled = Triangulate(stripes_, DeviceOrders(device_), {});
  p.u = p.row_u;
  const Triangulation moved = Triangulate(stripes_, DeviceOrders(device_), {});
  EXPECT_NEAR(pooled.points[3].row_z, moved.points[3].position.z(), 1e-3);
  EXPECT_NEAR(pooled.points[3].row_sigma, 2.0F * plain.points[3].sigma, 1e-4);
}

TEST_F(TriangulationTest, TheCorrectionMovesAPointAlongItsRayToTheCorrectedHeight) {
  device_.lasers[1].correction.c = {0.02, 1e-4, -2e-4, 0.0, 0.0, 1e-6};
  const Triangulation t = Triangulate(stripes_, DeviceOrders(device_), {});
  ASSERT_EQ(t.points.size(), truth_.size());
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const double z = device_.lasers[1].correction.CorrectedZ(truth_[i].x(), truth_[i].z());
    EXPECT_NEAR(t.points[i].position.z(), z, 2e-3);
    const Eigen::Vector2d pixel = Project(device_.camera, t.points[i].position);
    EXPECT_NEAR(pixel.x(), t.points[i].u, 1e-3);
    EXPECT_NEAR(pixel.y(), t.points[i].v, 1e-3);
  }
  const Triangulation raw = Triangulate(stripes_, DeviceOrders(device_), {.correction = false});
  EXPECT_LT((raw.points[7].position - truth_[7]).norm(), 2e-3);
}

TEST_F(TriangulationTest, PointsWithoutOrderOrSheetAreCountedAndLeftOut) {
  stripes_.lasers[0].segments[1].order.reset();
  stripes_.lasers[0].segments[2].order = 99;
  const Triangulation t = Triangulate(stripes_, DeviceOrders(device_), {});
  EXPECT_EQ(t.points.size(), 40U);
  EXPECT_EQ(t.without_order, 20);
  EXPECT_EQ(t.without_sheet, 20);
  const Triangulation cones = Triangulate(stripes_, DeviceOrders(device_), {.sheets = SheetModel::kCone});
  EXPECT_TRUE(cones.points.empty());
  EXPECT_EQ(cones.without_sheet, 60);
}

TEST_F(TriangulationTest, SigmaIsTheStripesNoiseCarriedThroughTheIntersection) {
  const Triangulation t = Triangulate(stripes_, DeviceOrders(device_), {});
  IndexedStripes shifted = stripes_;
  for (StripePoint& p : shifted.lasers[0].points) p.u += 0.1F;  // one standard deviation
  const Triangulation s = Triangulate(shifted, DeviceOrders(device_), {});
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    EXPECT_GT(t.points[i].sigma, 0.0F);
    const double moved = std::abs(s.points[i].position.z() - t.points[i].position.z());
    EXPECT_NEAR(t.points[i].sigma, moved, 0.02 * moved);
  }
  device_.lasers[1].residual_mm = 3.0;
  const float with_residual = Triangulate(stripes_, DeviceOrders(device_), {}).points[0].sigma;
  EXPECT_NEAR(with_residual, std::hypot(3.0, t.points[0].sigma), 1e-3);
}

TEST_F(TriangulationTest, AnUnknownLaserGivesNothing) {
  stripes_.lasers[0].laser = 7;
  EXPECT_TRUE(Triangulate(stripes_, DeviceOrders(device_), {}).points.empty());
}

TEST_F(TriangulationTest, TheSameBytesComeWithOneThreadAndWithMany) {
  const Triangulation one = Triangulate(stripes_, DeviceOrders(device_), {}, WithThreads(1));
  const Triangulation many = Triangulate(stripes_, DeviceOrders(device_), {}, WithThreads(4));
  ASSERT_EQ(one.points.size(), many.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i)
    EXPECT_EQ(one.points[i].position, many.points[i].position);
}

}  // namespace
}  // namespace dorsum
