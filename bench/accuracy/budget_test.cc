// SPDX-License-Identifier: Apache-2.0
#include "accuracy/budget.h"

#include <cmath>

#include <gtest/gtest.h>

#include "accuracy/true_device.h"
#include "base/temp_folder_test.h"
#include "simulator/named_scene.h"
#include "simulator/small_device_test.h"
#include "simulator/truth.h"
#include "simulator/truth_files.h"

namespace dorsum::accuracy {
namespace {

// A box before a coarse device, with the truth read back from its files.
class BudgetTest : public testing::Test {
 protected:
  void SetUp() override {
    const VirtualDevice device = BuildVirtualDevice(CoarseDevice(240), NamedSeed("budget"));
    const auto name = ParseSceneName("box25.5");
    const auto stage = SetStage(device, BuildNamedScene(device, *name, device.seed, device.seed), {});
    ASSERT_TRUE(stage.ok());
    std::filesystem::create_directories(folder_ / "box");
    ASSERT_TRUE(WriteSurfaceTruth(*stage, folder_ / "box").ok());
    for (int k = 0; k < static_cast<int>(device.lasers.size()); ++k) {
      ASSERT_TRUE(WriteStripeTruth(device, *stage, k, folder_ / "box", {}).ok());
    }
    ASSERT_TRUE(WriteJson(folder_ / "device.json", DeviceToJson(device)).ok());
    auto truth = ReadCaptureTruth(folder_ / "box", folder_ / "device.json");
    auto true_device = ReadTrueDevice(folder_ / "device.json");
    ASSERT_TRUE(truth.ok() && true_device.ok());
    truth_ = std::move(truth).value();
    device_ = std::move(true_device).value();
  }

  // The points of a reconstruction that sees the true stripes `shift_px` aside, counts every `every`-th point
  // one order too high, and believes `calibrated`.
  SurfacePoints Points(const DeviceGeometry& calibrated, double shift_px, int every) const {
    SurfacePoints points;
    for (const auto& [laser, stripes] : truth_.lasers) {
      for (const TrueStripe& s : stripes) {
        if (s.material != 3 || std::abs(s.z - 25.5) > 1e-3) continue;
        SurfacePoint p;
        const bool miscounted = every > 0 && points.size() % static_cast<std::size_t>(every) == 0;
        const int order = s.order + (miscounted ? 1 : 0);
        const auto at =
            IntersectSheet(CastRay(calibrated.camera, {s.u + shift_px, static_cast<double>(s.row)}),
                           *calibrated.FindLaser(laser), SheetModel::kCone, order);
        if (!at) continue;
        p.position = *at;
        p.laser = static_cast<std::uint8_t>(laser);
        p.order = static_cast<std::int16_t>(order);
        p.u = static_cast<float>(s.u + shift_px);
        p.v = static_cast<float>(s.row);
        p.sigma = 0.1F;
        points.push_back(p);
      }
    }
    return points;
  }

  Figures Budget(const DeviceGeometry& calibrated, const SurfacePoints& points) const {
    ReconstructOptions options;
    options.sheets = "cone";
    options.correction = "none";
    options.height_field.pitch_mm = 3.0;  // about two of these coarse pixels
    return ErrorBudget(truth_, device_, calibrated, options, points, {});
  }

  TempFolder folder_;
  CaptureTruth truth_;
  DeviceGeometry device_;
};

TEST_F(BudgetTest, TheTrueDeviceExplainsTheTrueStripes) {
  const Figures f = Budget(device_, Points(device_, 0.0, 0));
  EXPECT_LT(f.at("total"), 0.003);  // heights of truth are stored in steps of 0.002 mm
  EXPECT_LT(f.at("plane"), 0.001);
  EXPECT_LT(f.at("ridge"), 0.003);
  EXPECT_LT(f.at("index"), 0.001);
  EXPECT_EQ(f.at("stray"), 0.0);
  EXPECT_LT(f.at("fusion"), 0.003);
}

TEST_F(BudgetTest, AShiftedRidgeIsChargedToTheRidge) {
  const Figures f = Budget(device_, Points(device_, 0.3, 0));
  EXPECT_GT(f.at("ridge"), 0.1);
  EXPECT_NEAR(f.at("ridge"), f.at("total"), 0.003);
  EXPECT_LT(f.at("plane"), 0.001);
  EXPECT_LT(f.at("without_ridge"), 0.003);
}

TEST_F(BudgetTest, AShiftedSheetIsChargedToThePlane) {
  DeviceGeometry calibrated = device_;
  for (LaserGeometry& laser : calibrated.lasers) laser.fan->origin.x() += 0.2;
  const Figures f = Budget(calibrated, Points(calibrated, 0.0, 0));
  EXPECT_GT(f.at("plane"), 0.1);
  EXPECT_NEAR(f.at("plane"), f.at("total"), 0.003);
  EXPECT_LT(f.at("ridge"), 0.003);
  EXPECT_LT(f.at("without_plane"), 0.003);
}

TEST_F(BudgetTest, AWrongOrderIsChargedToTheIndex) {
  const Figures f = Budget(device_, Points(device_, 0.0, 10));
  EXPECT_GT(f.at("index"), 5.0);
  EXPECT_NEAR(f.at("index"), f.at("total"), 0.01);
  EXPECT_LT(f.at("plane"), 0.001);
  EXPECT_LT(f.at("without_index"), 0.003);
}

TEST_F(BudgetTest, APointBesideEveryStripeIsChargedToStrays) {
  SurfacePoints points = Points(device_, 0.0, 0);
  for (std::size_t i = 0; i < points.size(); i += 20) {
    points[i].u += 4.0F;
    points[i].position.z() += 3.0;
  }
  const Figures f = Budget(device_, points);
  EXPECT_GT(f.at("stray"), 0.3);
  EXPECT_LT(f.at("without_stray"), 0.003);
}

}  // namespace
}  // namespace dorsum::accuracy
