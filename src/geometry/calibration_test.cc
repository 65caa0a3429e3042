// SPDX-License-Identifier: Apache-2.0
#include "geometry/calibration.h"

#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

DiffractedFan TestFan(FanForm form) {
  DiffractedFan fan;
  fan.origin = {60.0, 0.0, kTestGratingHeight};
  fan.fan_distance_mm = 4.0;
  fan.tilt = 0.05;
  fan.step = 0.027;
  fan.form = form;
  return fan;
}

TEST(Calibration, PlanesAPointOfAnOrderIsSeenAsThatOrderAtItsHeight) {
  const DeviceGeometry device = TestDevice();
  const LaserGeometry& laser = device.lasers[1];
  for (const int m : {-20, -7, 0, 1, 19, 20}) {
    for (const double z : {0.0, 12.5, 79.0}) {
      const Eigen::Vector3d p = OnSheet(*laser.FindPlane(m), 25.0, z);
      const Eigen::Vector2d pixel = Project(device.camera, p);
      const auto order = OrderAtHeight(device.camera, laser, SheetModel::kPlane, pixel, z);
      ASSERT_TRUE(order.has_value());
      EXPECT_NEAR(*order, m, 1e-9);
      const auto met = IntersectSheet(CastRay(device.camera, pixel), laser, SheetModel::kPlane, m);
      ASSERT_TRUE(met.has_value());
      EXPECT_LT((*met - p).norm(), 1e-9);
    }
  }
}

TEST(Calibration, PlanesBetweenAndBeyondTheSheetsTheOrderGoesOn) {
  const DeviceGeometry device = TestDevice();
  const LaserGeometry& laser = device.lasers[1];
  const auto at = [&](double x) {
    return OrderAtHeight(device.camera, laser, SheetModel::kPlane, Project(device.camera, {x, 0.0, 0.0}), 0.0)
        .value();
  };
  EXPECT_NEAR(at(60.0 + 2.5 * kTestSpacing), 2.5, 0.01);
  EXPECT_NEAR(at(60.0 + 22.0 * kTestSpacing), 22.0, 0.3);
  EXPECT_NEAR(at(60.0 - 22.0 * kTestSpacing), -22.0, 0.3);
  double previous = at(-150.0);
  for (double x = -149.0; x < 150.0; x += 1.0) {
    EXPECT_GT(at(x), previous);
    previous = at(x);
  }
}

TEST(Calibration, ConesAPointOfAnOrderIsSeenAsThatOrderAtItsHeight) {
  for (const FanForm form : {FanForm::kFlat, FanForm::kConical}) {
    Camera camera = TestCamera();
    camera.distortion = {-0.1, 0.05, 0.001, -0.001, 0.0};
    LaserGeometry laser;
    laser.fan = TestFan(form);
    for (const int m : {-8, 0, 5}) {
      for (const double beta : {-0.25, 0.0, 0.2}) {
        const auto light = DiffractedRay(*laser.fan, m, beta);
        ASSERT_TRUE(light.has_value());
        for (const double z : {0.0, 40.0, 79.0}) {
          const Eigen::Vector3d p = light->At(*Intersect(*light, Plane{Eigen::Vector3d::UnitZ(), z}));
          const Eigen::Vector2d pixel = Project(camera, p);
          EXPECT_NEAR(OrderAtHeight(camera, laser, SheetModel::kCone, pixel, z).value(), m, 1e-8);
          const auto met = IntersectSheet(CastRay(camera, pixel), laser, SheetModel::kCone, m);
          ASSERT_TRUE(met.has_value());
          EXPECT_LT((*met - p).norm(), 1e-6) << "order " << m << ", height " << z;
        }
      }
    }
  }
}

TEST(Calibration, AMissingModelOrOrderGivesNothing) {
  const DeviceGeometry device = TestDevice();
  const LaserGeometry& laser = device.lasers[1];
  const Ray ray = CastRay(device.camera, {320.0, 240.0});
  EXPECT_FALSE(IntersectSheet(ray, laser, SheetModel::kCone, 0).has_value());
  EXPECT_FALSE(IntersectSheet(ray, laser, SheetModel::kPlane, 21).has_value());
  EXPECT_FALSE(OrderAtHeight(device.camera, laser, SheetModel::kCone, {320.0, 240.0}, 0.0).has_value());
  EXPECT_FALSE(OrderAtHeight(device.camera, laser, SheetModel::kPlane, {320.0, 240.0}, 401.0).has_value());
  const LaserGeometry one_plane = TestLaser(0, 0.0, 3, 3);
  EXPECT_FALSE(OrderAtHeight(device.camera, one_plane, SheetModel::kPlane, {320.0, 240.0}, 0.0).has_value());
}

TEST(Calibration, CorrectionIsEquation37And39) {
  const CorrectionPolynomial p{{0.01, 2e-4, 3e-4, 4e-6, 5e-6, 6e-6}};
  const double x = 30.0, z = 20.0;
  const double e = 0.01 + 2e-4 * x + 3e-4 * z + 4e-6 * x * x + 5e-6 * x * z + 6e-6 * z * z;
  EXPECT_NEAR(p.Evaluate(x, z), e, 1e-15);
  EXPECT_NEAR(p.CorrectedZ(x, z), z * (1.0 - e), 1e-12);
  EXPECT_EQ(CorrectionPolynomial{}.CorrectedZ(30.0, 20.0), 20.0);
}

TEST(Calibration, AReferenceStripeIsAPolynomialOfItsRows) {
  ReferenceStripe r;
  r.middle_v = 200.0;
  r.half_v = 100.0;
  r.u = {50.0, 4.0, 2.0, 1.0};
  r.peak = {90.0, -10.0, -5.0};
  EXPECT_EQ(r.ColumnAt(200.0), 50.0);
  EXPECT_EQ(r.ColumnAt(300.0), 57.0);
  EXPECT_EQ(r.ColumnAt(100.0), 47.0);
  EXPECT_EQ(r.PeakAt(300.0), 75.0);
  EXPECT_EQ(r.PeakAt(150.0), 90.0 + 5.0 - 1.25);
  EXPECT_TRUE(r.Covers(100.0));
  EXPECT_TRUE(r.Covers(300.0));
  EXPECT_FALSE(r.Covers(99.0));
  EXPECT_FALSE(r.Covers(301.0));
}

TEST(Calibration, LasersAndPlanesAreFoundByTheirNumber) {
  DeviceGeometry device = TestDevice();
  device.lasers[1].laser = 5;
  EXPECT_EQ(device.FindLaser(5), &device.lasers[1]);
  EXPECT_EQ(device.FindLaser(1), nullptr);
  EXPECT_EQ(device.lasers[0].FindPlane(-20), device.lasers[0].planes.data());
  EXPECT_EQ(device.lasers[0].FindPlane(-21), nullptr);
}

}  // namespace
}  // namespace dorsum
