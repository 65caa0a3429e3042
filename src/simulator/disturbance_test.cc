// SPDX-License-Identifier: Apache-2.0
#include "simulator/disturbance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "simulator/named_scene.h"
#include "simulator/renderer.h"
#include "simulator/small_device_test.h"
#include "simulator/truth.h"

namespace dorsum {
namespace {

constexpr std::uint64_t kSeed = 4;

VirtualDevice Device() { return BuildVirtualDevice(WithoutNoise(CoarseDevice()), 2); }

VirtualDevice With(const VirtualDevice& device, const std::string& words) {
  const auto modifiers = ParseModifiers(words, false);
  EXPECT_TRUE(modifiers.ok());
  return Disturb(device, *modifiers, kSeed);
}

Stage StageOf(const VirtualDevice& device, const std::string& scene) {
  auto stage = SetStage(device, BuildNamedScene(device, *ParseSceneName(scene), 1, 1), Context{});
  EXPECT_TRUE(stage.ok());
  return std::move(stage).value();
}

cv::Mat Green(const cv::Mat& picture) {
  cv::Mat green;
  cv::extractChannel(picture, green, 1);
  return green;
}

cv::Mat LaserPicture(const VirtualDevice& device, const Stage& stage, int laser) {
  return Green(*RenderLaser(device, stage, laser, 1, Context{}));
}

std::vector<TrueStripePoint> Truth(const VirtualDevice& device, const Stage& stage, int laser) {
  auto points = TrueStripes(device, stage, laser, Context{});
  EXPECT_TRUE(points.ok());
  return std::move(points).value();
}

TEST(Disturbance, ALaserThatIsOffLeavesNeitherLightNorTruth) {
  const VirtualDevice device = Device(), off = With(device, "off1");
  const Stage stage = StageOf(device, "box20");
  double brightest = 0.0;
  cv::minMaxLoc(LaserPicture(off, stage, 1), nullptr, &brightest);
  EXPECT_EQ(brightest, 0.0);
  EXPECT_TRUE(Truth(off, stage, 1).empty());
  EXPECT_EQ(cv::norm(LaserPicture(off, stage, 0), LaserPicture(device, stage, 0), cv::NORM_INF), 0.0);
}

TEST(Disturbance, ADimLaserHasThirtyPerCentOfItsLight) {
  const VirtualDevice device = Device(), dim = With(device, "dim0");
  const Stage stage = StageOf(device, "plane");
  const cv::Mat before = LaserPicture(device, stage, 0), after = LaserPicture(dim, stage, 0);
  const cv::Mat usable = (before > 40) & (before < 250);
  ASSERT_GT(cv::countNonZero(usable), 500);
  EXPECT_NEAR(cv::mean(after, usable)[0] / cv::mean(before, usable)[0], 0.3, 0.01);
  const auto a = Truth(device, stage, 0), b = Truth(dim, stage, 0);
  ASSERT_FALSE(b.empty());
  EXPECT_NEAR(b.front().irradiance / a.front().irradiance, 0.3, 1e-9);
}

TEST(Disturbance, DustDimsAllStripesOverTheSameAngles) {
  const VirtualDevice device = Device(), dusty = With(device, "dust2");
  ASSERT_EQ(dusty.lasers[2].dirt.size(), 1U);
  const DirtySpot spot = dusty.lasers[2].dirt[0];
  const Stage stage = StageOf(device, "plane");
  std::map<std::pair<int, int>, double> clean;
  for (const TrueStripePoint& p : Truth(device, stage, 2)) clean[{p.order, p.row}] = p.irradiance;
  std::map<int, int> dimmed, untouched;  // by order
  for (const TrueStripePoint& p : Truth(dusty, stage, 2)) {
    const double left = p.irradiance / clean.at({p.order, p.row});
    const Ray ray = CastRay(device.camera, {p.u, static_cast<double>(p.row)});
    const auto at = Locate(device.lasers[2].fan, ray.At((p.z - ray.origin.z()) / ray.direction.z()));
    ASSERT_TRUE(at.has_value());
    const double distance = std::abs(at->beta - spot.beta) / spot.half_width;
    if (distance < 0.5) {
      EXPECT_LT(left, spot.transmission + 0.02);
    } else if (distance > 2.0) {
      EXPECT_GT(left, 0.99);
    }
    dimmed[p.order] += left < 0.3;
    untouched[p.order] += left > 0.99;
  }
  for (int m = -8; m <= 8; ++m) {
    EXPECT_GT(dimmed[m], 0) << m;
    EXPECT_GT(untouched[m], dimmed[m]) << m;
  }
  EXPECT_LT(cv::sum(LaserPicture(dusty, stage, 2))[0], 0.97 * cv::sum(LaserPicture(device, stage, 2))[0]);
}

TEST(Disturbance, MoreDaylightLightsTheDarkPicture) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 2), bright = With(device, "ambient10");
  const Stage stage = StageOf(device, "plane");
  const double dark = cv::mean(Green(*RenderDark(device, stage, 1, Context{})))[0];
  const double lit = cv::mean(Green(*RenderDark(bright, stage, 1, Context{})))[0];
  EXPECT_GT(dark, 1.0);
  EXPECT_NEAR(lit / dark, 10.0, 1.0);
}

TEST(Disturbance, AKnockedCameraTurnsAboutItsCentreAndTheWorldStays) {
  const VirtualDevice device = Device(), knocked = With(device, "knocked0.2");
  EXPECT_LT((device.camera.Center() - knocked.camera.Center()).norm(), 1e-9);
  const Eigen::Matrix3d turn =
      knocked.camera.camera_from_world.rotation * device.camera.camera_from_world.rotation.transpose();
  const double angle = std::acos(std::clamp(0.5 * (turn.trace() - 1.0), -1.0, 1.0));
  EXPECT_NEAR(angle, 0.2 * std::numbers::pi / 180.0, 1e-6);
  EXPECT_EQ(device.lasers[0].fan.origin, knocked.lasers[0].fan.origin);
  const auto before = StageOf(device, "box20").tracer.scene().parts[1].mesh.vertices;
  const Scene scene = BuildNamedScene(device, *ParseSceneName("box20"), 1, 1);
  EXPECT_EQ(before, scene.parts[1].mesh.vertices);
  // The truth of the turned view lies on the same sheets at the same heights.
  const auto stage = SetStage(knocked, scene, Context{});
  ASSERT_TRUE(stage.ok());
  double moved = 0.0;
  for (const TrueStripePoint& p : Truth(knocked, *stage, 0)) {
    const Ray ray = CastRay(knocked.camera, {p.u, static_cast<double>(p.row)});
    const Eigen::Vector3d point = ray.At((p.z - ray.origin.z()) / ray.direction.z());
    EXPECT_NEAR(Locate(device.lasers[0].fan, point)->Order(device.lasers[0].fan), p.order, 1e-6);
    const Eigen::Vector2d seen(p.u, p.row);
    moved = std::max(moved, (Project(device.camera, point) - seen).norm());
  }
  EXPECT_GT(moved, 0.3) << "px; 0.2 degrees are 1.5 px here, less where the turn is about the axis of view";
}

TEST(Disturbance, MotionIsOfTheAskedLengthAndStartsHalfWay) {
  const auto modifiers = ParseModifiers("moved1.5", false);
  const auto motion = MotionOf(*modifiers, 4, kSeed);
  ASSERT_TRUE(motion.has_value());
  EXPECT_NEAR(motion->offset_mm.norm(), 1.5, 1e-12);
  EXPECT_EQ(motion->offset_mm.z(), 0.0);
  EXPECT_EQ(motion->from_laser, 2);
  EXPECT_FALSE(MotionOf({}, 4, kSeed).has_value());
}

TEST(Disturbance, LasersMustBeThere) {
  EXPECT_TRUE(CheckLasers(*ParseModifiers("off3", false), 4).ok());
  const Status refused = CheckLasers(*ParseModifiers("dust3", false), 2);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace dorsum
