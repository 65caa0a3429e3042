// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/calibration.h"
#include "jobs/design_ambiguity.h"
#include "jobs/design_changes.h"
#include "jobs/design_combs.h"
#include "jobs/design_report.h"
#include "simulator/virtual_device.h"

namespace dorsum {
namespace {

// The default device with nothing that differs from part to part, so that the simulator's truth is the
// design.
DeviceDescription Exact(DeviceDescription d = DefaultDevice()) {
  d.mounting = {0, 0, 0, 0, 0, 0, 0};
  d.grating.efficiency_spread = 0.0;
  for (LaserDesign& laser : d.lasers) laser.fan_distance_mm = 0.0;
  return d;
}

DesignedDevice LaidOut(const DeviceDescription& d) {
  const auto device = LayOutDevice(d, {190.0, 110.0});
  EXPECT_TRUE(device.ok()) << device.error().message;
  return *device;
}

// The simulator's world is the design's frame, shifted within the backplane.
Eigen::Vector3d WorldShift(const VirtualDevice& truth, const DesignedDevice& designed) {
  return truth.lasers[0].fan.origin - designed.lasers[0].fan.origin;
}

TEST(DesignGeometry, TheDesignIsTheVirtualDeviceWithoutItsErrors) {
  const DeviceDescription d = Exact();
  const VirtualDevice truth = BuildVirtualDevice(d, 5);
  const DesignedDevice designed = LaidOut(d);
  const Eigen::Vector3d shift = WorldShift(truth, designed);
  EXPECT_NEAR(shift.z(), 0.0, 1e-9);
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 0), {-80, 40, 30}, {90, -50, 80}}) {
    EXPECT_LT((Project(truth.camera, p + shift) - Project(designed.camera, p)).norm(), 1e-7);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(Locate(truth.lasers[k].fan, p + shift)->Order(truth.lasers[k].fan),
                  Locate(designed.lasers[k].fan, p)->Order(designed.lasers[k].fan), 1e-9);
    }
  }
  for (int m = 0; m <= 10; ++m) {
    EXPECT_NEAR(designed.lasers[1].efficiency[static_cast<std::size_t>(m)], truth.lasers[1].Efficiency(-m),
                1e-12);
  }
}

TEST(DesignGeometry, OrdersMeetThePlanesWhereTheSimulatorHasThem) {
  const DeviceDescription d = Exact();
  const VirtualDevice truth = BuildVirtualDevice(d, 5);
  const DesignReport report = JudgeDesign(LaidOut(d), {});
  const Eigen::Vector3d shift = WorldShift(truth, report.device);
  ASSERT_EQ(report.orders.size(), 21U);
  for (const OrderFigures& o : report.orders) {
    const auto ray = DiffractedRay(truth.lasers[0].fan, o.order, 0.0);
    EXPECT_NEAR(ray->At(*Intersect(*ray, {Eigen::Vector3d::UnitZ(), 0.0})).x() - shift.x(), o.low_mm, 1e-9);
    EXPECT_NEAR(ray->At(*Intersect(*ray, {Eigen::Vector3d::UnitZ(), 80.0})).x() - shift.x(), o.high_mm, 1e-9);
    // Equation 2.6 by hand.
    EXPECT_NEAR(o.angle_deg, std::asin(o.order * 0.0532 * std::sqrt(0.5)) * 180.0 / 3.14159265358979, 1e-9);
  }
  const StripePointOnPlane central = CentralStripeAt(truth.lasers[0].fan, 0.0, shift.y());
  EXPECT_NEAR(central.point.x() - shift.x(), report.orders[10].low_mm, 1e-9);
  EXPECT_NEAR(report.orders[10].described, 1.0, 0.0);
  EXPECT_NEAR(report.orders[20].described, 0.17, 1e-12);
  EXPECT_NEAR(report.orders[20].slit, 0.17, 1e-9) << "the stated slit's envelope";
}

// What the height of a ray with a sheet does when the stripe moves by a pixel, with the sheets themselves.
TEST(DesignGeometry, DepthPerPixelIsWhatTheSheetsGive) {
  DeviceDescription d = DefaultDevice();
  d.lasers[2].tilt_deg = 3.0;
  const DesignedDevice device = LaidOut(d);
  for (const std::size_t k : {0U, 2U}) {
    LaserGeometry laser;
    laser.fan = device.lasers[k].fan;
    laser.min_order = -10;
    laser.max_order = 10;
    for (const int order : {-5, 0, 3}) {
      for (const double beta : {0.0, 0.11}) {
        for (const double z : {0.0, 37.0, 80.0}) {
          const auto light = DiffractedRay(*laser.fan, order, beta);
          const Eigen::Vector3d point = light->At(*Intersect(*light, {Eigen::Vector3d::UnitZ(), z}));
          const auto figures = FiguresAt(device, device.lasers[k], point);
          ASSERT_TRUE(figures);
          EXPECT_NEAR(figures->order, order, 1e-6);
          const auto height = [&](double du) {
            const Ray ray = CastRay(device.camera, figures->pixel + Eigen::Vector2d(du, 0.0));
            return IntersectSheet(ray, laser, SheetModel::kCone, order, z)->z();
          };
          const double slope = (height(0.5) - height(-0.5));
          EXPECT_NEAR(std::abs(slope) / figures->DepthPerPx(), 1.0, 1e-3) << k << order << beta << z;
        }
      }
    }
  }
}

// Follows the rays of many pixels and lists the heights at which they meet sheets.
TEST(DesignGeometry, UnambiguousHeightIsTheLeastOfAllPixels) {
  const DesignedDevice device = LaidOut(DefaultDevice());
  const HeightAmbiguity found = FindAmbiguity(device);
  for (const std::size_t k : {0U, 3U}) {
    LaserGeometry laser;
    laser.fan = device.lasers[k].fan;
    double least = 1e9;
    for (int r = 0; r < 5; ++r) {
      for (int c = 0; c < 400; ++c) {
        const double x =
            device.hand.min().x() + device.hand.sizes().x() * (c / 400.0 * 8.0 / 9.0 + 0.5 / 9.0);
        const double y = device.hand.min().y() + device.hand.sizes().y() * (r + 0.5) / 5.0;
        const Eigen::Vector3d eye = device.camera.Center();
        const Ray ray{eye, (Eigen::Vector3d(x, y, 40.0) - eye).normalized()};
        std::vector<double> heights;
        for (int m = -30; m <= 30; ++m) {
          const auto at = IntersectSheet(ray, laser, SheetModel::kCone, m, 40.0);
          if (at && at->z() >= 0.0 && at->z() <= 80.0) heights.push_back(at->z());
        }
        std::sort(heights.begin(), heights.end());
        for (std::size_t i = 1; i < heights.size(); ++i) least = std::min(least, heights[i] - heights[i - 1]);
      }
    }
    EXPECT_NEAR(found.single_mm[k] / least, 1.0, 0.02) << k;
    EXPECT_FALSE(found.beyond_volume[k]);
  }
}

TEST(DesignGeometry, LasersInOnePlaceCannotHelpEachOther) {
  DeviceDescription d = DefaultDevice();
  PlaceLasers(2, 1e-6, 0.0, &d.lasers);
  const HeightAmbiguity same = FindAmbiguity(LaidOut(d));
  ASSERT_TRUE(same.joint_mm);
  EXPECT_NEAR(*same.joint_mm, same.single_mm[0], 0.05 * same.single_mm[0]);
  EXPECT_LT(*same.joint_margin_mm, 0.01);
  const HeightAmbiguity apart = FindAmbiguity(LaidOut(DefaultDevice()));
  EXPECT_FALSE(apart.joint_mm);
  EXPECT_GT(*apart.joint_margin_mm, 2.0);
}

TEST(DesignGeometry, ASmallVolumeIsFreeOfNeighbours) {
  DeviceDescription d = DefaultDevice();
  d.working_heights_mm = {0.0, 20.0};
  const HeightAmbiguity a = FindAmbiguity(LaidOut(d));
  EXPECT_TRUE(a.beyond_volume[1]);
  EXPECT_GT(a.single_mm[1], 20.0);
  EXPECT_LT(a.single_mm[1], 80.0);
  EXPECT_FALSE(a.joint_margin_mm);
}

TEST(DesignGeometry, CombsThatCoincideAreTold) {
  DeviceDescription d = DefaultDevice();
  PlaceLasers(2, 0.5 * d.grating.Step() * 395.0, 0.0, &d.lasers);
  const CombFigures half = FindCombs(LaidOut(d), 0.0);
  EXPECT_NEAR(half.closest, 0.49, 0.02);
  EXPECT_NEAR(half.largest_gap_mm, 0.5 * half.spacing_mm, 0.3);
  EXPECT_NEAR(half.any_coverage, 1.0, 1e-12);
  PlaceLasers(2, d.grating.Step() * 395.0, 0.0, &d.lasers);
  const DesignReport same = JudgeDesign(LaidOut(d), {});
  EXPECT_LT(same.combs.front().closest, 0.05);
  ASSERT_FALSE(same.warnings.empty());
  EXPECT_NE(same.warnings[0].find("lie on one another"), std::string::npos);
}

TEST(DesignGeometry, FewOrdersOrANarrowFanCoverLess) {
  DeviceDescription d = DefaultDevice();
  d.grating.orders = 3;
  const CombFigures few = FindCombs(LaidOut(d), 0.0);
  // 3.5 spacings to either side of the 190 mm.
  EXPECT_NEAR(few.coverage[1], 2.0 * 3.5 * 15.1 / 190.0, 0.05);
  d = DefaultDevice();
  for (LaserDesign& laser : d.lasers) laser.half_angle_deg = 4.0;
  EXPECT_NEAR(FindCombs(LaidOut(d), 0.0).coverage[1], 2.0 * 410.0 * std::tan(4.0 * 3.14159 / 180.0) / 110.0,
              0.08);
}

TEST(DesignGeometry, ADeviceThatCannotSeeIsRefused) {
  DeviceDescription d = DefaultDevice();
  d.camera.position_mm.z() = 100.0;
  d.working_heights_mm[1] = 90.0;
  EXPECT_FALSE(LayOutDevice(d, {190, 110}).ok());
  d = DefaultDevice();
  d.lasers[1].position_mm.z() = 100.0;
  d.working_heights_mm[1] = 95.0;
  EXPECT_FALSE(LayOutDevice(d, {190, 110}).ok());
  d = DefaultDevice();
  d.camera.look_at_mm = {4000.0, 0.0, 90.0};
  EXPECT_FALSE(LayOutDevice(d, {190, 110}).ok());
}

}  // namespace
}  // namespace dorsum
