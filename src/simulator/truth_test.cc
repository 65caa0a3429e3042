// SPDX-License-Identifier: Apache-2.0
#include "simulator/truth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "simulator/named_scene.h"
#include "simulator/small_device_test.h"

namespace dorsum {
namespace {

Stage StageOf(const VirtualDevice& device, Scene scene) {
  auto stage = SetStage(device, std::move(scene), Context{});
  EXPECT_TRUE(stage.ok());
  return std::move(stage).value();
}

Scene Named(const VirtualDevice& device, const std::string& text) {
  const auto name = ParseSceneName(text);
  EXPECT_TRUE(name.ok());
  return BuildNamedScene(device, *name, 1, 1);
}

Eigen::Vector3d WorldPoint(const Camera& camera, const TrueStripePoint& p) {
  const Ray ray = CastRay(camera, {p.u, static_cast<double>(p.row)});
  return ray.At((p.z - ray.origin.z()) / ray.direction.z());
}

// The light of one order traced forward from the laser, straight from the physics: a flat fan of rays that
// starts s behind the grating, the grating adding m times lambda / d to one direction cosine. Returns the
// distance in direction cosine between the ray of that fan which reaches the point's height in the fan and
// the point itself.
double CosineError(const DiffractedFan& fan, int order, const Eigen::Vector3d& point) {
  const Eigen::Vector3d middle = std::sin(fan.tilt) * fan.a + std::cos(fan.tilt) * fan.n;
  const Eigen::Vector3d start = fan.origin - fan.fan_distance_mm / std::cos(fan.tilt) * middle;
  const auto error_at = [&](double angle, double* across) {
    const Eigen::Vector3d in = std::cos(angle) * middle + std::sin(angle) * fan.b;
    const double t = fan.fan_distance_mm / in.dot(fan.n);
    const Eigen::Vector3d exit = start + t * in;
    const double alpha = in.dot(fan.a) + order * fan.step, beta = in.dot(fan.b);
    const Eigen::Vector3d to_point = (point - exit).normalized();
    if (across != nullptr) *across = to_point.dot(fan.a) - alpha;
    return to_point.dot(fan.b) - beta;
  };
  double low = -1.2, high = 1.2;  // rad; the error along the line falls with the angle
  for (int i = 0; i < 200; ++i) {
    const double mid = 0.5 * (low + high);
    (error_at(mid, nullptr) > 0.0 ? low : high) = mid;
  }
  double across = 0.0;
  error_at(0.5 * (low + high), &across);
  return across;
}

TEST(TrueStripes, PointsSatisfyTheDiffractionFormula) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 11);
  for (const char* scene : {"box25.5", "sphere25"}) {
    const Stage stage = StageOf(device, Named(device, scene));
    for (int k = 0; k < 4; ++k) {
      const auto points = TrueStripes(device, stage, k, Context{});
      ASSERT_TRUE(points.ok());
      ASSERT_GT(points->size(), 2000U);
      for (const TrueStripePoint& p : *points) {
        const DiffractedFan& fan = device.lasers[static_cast<std::size_t>(k)].fan;
        ASSERT_NEAR(CosineError(fan, p.order, WorldPoint(device.camera, p)), 0.0, 1e-6)
            << scene << " laser " << k;
      }
    }
  }
}

TEST(TrueStripes, ConicalFansAreTracedToo) {
  DeviceDescription d = CoarseDevice(200);
  for (LaserDesign& laser : d.lasers) laser.form = FanForm::kConical;
  d.lasers[0].tilt_deg = 3.0;
  const VirtualDevice device = BuildVirtualDevice(d, 5);
  const Stage stage = StageOf(device, Named(device, "plane"));
  const auto points = TrueStripes(device, stage, 0, Context{});
  ASSERT_TRUE(points.ok());
  ASSERT_GT(points->size(), 1000U);
  const DiffractedFan& fan = device.lasers[0].fan;
  for (const TrueStripePoint& p : *points) {
    // A cone about a whose rays all leave with the same alpha, from (0, y_g): s beta / gamma before the
    // grating.
    const Eigen::Vector3d d3 = WorldPoint(device.camera, p) - fan.origin;
    const double alpha_in = std::sin(fan.tilt), alpha = alpha_in + p.order * fan.step;
    double beta = 0.0;
    for (int i = 0; i < 100; ++i) {
      const double y_g = fan.fan_distance_mm * beta / std::sqrt(1.0 - alpha_in * alpha_in - beta * beta);
      const double dy = fan.b.dot(d3) - y_g;
      beta = dy / std::sqrt(std::pow(fan.a.dot(d3), 2) + dy * dy + std::pow(fan.n.dot(d3), 2));
    }
    const double y_g = fan.fan_distance_mm * beta / std::sqrt(1.0 - alpha_in * alpha_in - beta * beta);
    ASSERT_NEAR(fan.a.dot((d3 - y_g * fan.b).normalized()), alpha, 1e-6);
  }
}

TEST(TrueStripes, HeightMapAndStripesProjectOntoTheirPixels) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 3);
  const Stage stage = StageOf(device, Named(device, "box25.5"));
  for (int row = 5; row < stage.view.height; row += 17) {
    for (int u = 3; u < stage.view.width; u += 13) {
      const Eigen::Vector2d p = Project(device.camera, stage.view.At(u, row).position);
      EXPECT_LT((p - Eigen::Vector2d(u, row)).norm(), 0.01);
    }
  }
  const auto points = TrueStripes(device, stage, 1, Context{});
  ASSERT_TRUE(points.ok());
  std::map<int, int> materials;
  for (const TrueStripePoint& p : *points) {
    ++materials[static_cast<int>(p.material)];
    const Eigen::Vector3d world = WorldPoint(device.camera, p);
    EXPECT_LT((Project(device.camera, world) - Eigen::Vector2d(p.u, p.row)).norm(), 1e-6);
    if (p.material == Material::kBackplane) {
      EXPECT_NEAR(p.z, 0.0, 1e-9);
    }
    if (p.material == Material::kBrown) {
      EXPECT_LT(p.z, 25.5 + 1e-9);
    }
    EXPECT_GT(p.irradiance, 0.0);
    EXPECT_LE(std::abs(p.order), 10);
  }
  EXPECT_GT(materials[0], 500);
  EXPECT_GT(materials[3], 100);
}

// What the top of a box shows is what a plate of its height would, cut at the box's edges: also where a
// stripe leaves the top between two pixel centres.
TEST(TrueStripes, ReachToTheVeryEdge) {
  const VirtualDevice device = BuildVirtualDevice(WithoutNoise(CroppedDevice(1600, 160)), 2);
  BoxPlace box, plate;
  box.centre_mm = {-70.0, 0.0};
  box.size_mm = {60.0, 50.0};
  box.yaw = 0.15;
  box.height_mm = plate.height_mm = 25.5;
  plate.size_mm = {400.0, 400.0};
  Scene with_box, with_plate;
  with_box.parts = {Backplane(), BrownBox(box)};
  with_plate.parts = {Backplane(), BrownBox(plate)};
  const Stage box_stage = StageOf(device, with_box), plate_stage = StageOf(device, with_plate);
  int near_edge = 0;
  for (int k = 0; k < 4; ++k) {
    const auto on_box = TrueStripes(device, box_stage, k, Context{});
    const auto on_plate = TrueStripes(device, plate_stage, k, Context{});
    ASSERT_TRUE(on_box.ok() && on_plate.ok());
    std::map<std::pair<int, int>, double> top;
    for (const TrueStripePoint& p : *on_box) {
      if (std::abs(p.z - box.height_mm) < 1e-6) top[{p.row, p.order}] = p.u;
    }
    for (const TrueStripePoint& p : *on_plate) {
      const Eigen::Vector3d world = WorldPoint(device.camera, p);
      const Eigen::Vector2d own =
          Eigen::Rotation2Dd(-box.yaw) * (Eigen::Vector2d(world.x(), world.y()) - box.centre_mm);
      const double inside = (0.5 * box.size_mm - own.cwiseAbs()).minCoeff();
      const auto found = top.find({p.row, p.order});
      if (inside > 0.03) {  // mm; a tenth of a pixel
        ASSERT_NE(found, top.end()) << "row " << p.row << " order " << p.order;
        EXPECT_NEAR(found->second, p.u, 1e-6);
        near_edge += inside < 0.3 ? 1 : 0;
      } else if (inside < 0.0) {
        EXPECT_EQ(found, top.end()) << "row " << p.row << " order " << p.order;
      }
    }
  }
  EXPECT_GT(near_edge, 5);
}

TEST(TrueStripes, ABoxShadesTheStripeBehindIt) {
  const VirtualDevice device = BuildVirtualDevice(WithoutNoise(CroppedDevice(1600, 160)), 2);
  // A high wall left of the lasers: its shadow falls to the left, where the camera (further left) sees it.
  BoxPlace wall;
  wall.centre_mm = {-60.0, 0.0};
  wall.size_mm = {6.0, 30.0};
  wall.height_mm = 80.0;
  Scene scene;
  scene.parts = {Backplane(), BrownBox(wall)};
  const Stage stage = StageOf(device, scene);
  const Stage empty = StageOf(device, Named(device, "plane"));
  const auto points = TrueStripes(device, stage, 3, Context{});
  const auto unshaded = TrueStripes(device, empty, 3, Context{});
  const auto picture = RenderLaser(device, stage, 3, 1, Context{});
  ASSERT_TRUE(points.ok() && unshaded.ok() && picture.ok());
  int shaded = 0;
  for (const TrueStripePoint& p : *unshaded) {
    const int column = static_cast<int>(std::lround(p.u));
    if (column < 8 || column > stage.view.width - 9 || p.irradiance < 0.05) continue;
    const Eigen::Vector3d world = WorldPoint(device.camera, p);
    // In the shadow's middle: the way to the laser passes through the wall well inside.
    const Eigen::Vector3d exit = device.lasers[3].fan.origin;
    const double t = (-60.0 - world.x()) / (exit.x() - world.x());
    const Eigen::Vector3d through = world + t * (exit - world);
    const bool blocked = t > 0.0 && t < 1.0 && through.z() < 70.0 && std::abs(through.y()) < 10.0;
    if (!blocked || stage.view.At(column, p.row).material != Material::kBackplane) continue;
    ++shaded;
    EXPECT_LT(picture->at<cv::Vec3b>(p.row, column)[1], 6);
    for (const TrueStripePoint& q : *points) {
      if (q.row == p.row) {
        EXPECT_GT(std::abs(q.u - p.u), 1e-3) << "a true point in the shadow";
      }
    }
  }
  EXPECT_GT(shaded, 20);
}

TEST(TrueStripes, AnIdealDetectorIsUnbiasedOnAPlane) {
  const VirtualDevice device = BuildVirtualDevice(WithoutNoise(CroppedDevice()), 4);
  const Stage stage = StageOf(device, Named(device, "plane"));
  for (int k = 0; k < 4; ++k) {
    const auto points = TrueStripes(device, stage, k, Context{});
    const auto picture = RenderLaser(device, stage, k, 1, Context{});
    ASSERT_TRUE(points.ok() && picture.ok());
    std::vector<double> errors;
    for (const TrueStripePoint& p : *points) {
      const int middle = static_cast<int>(std::lround(p.u));
      if (middle < 10 || middle > stage.view.width - 11) continue;
      double sum = 0.0, moment = 0.0;
      for (int u = middle - 8; u <= middle + 8; ++u) {
        const double g = picture->at<cv::Vec3b>(p.row, u)[1];
        sum += g;
        moment += g * u;
      }
      ASSERT_GT(sum, 50.0);
      errors.push_back(moment / sum - p.u);
    }
    ASSERT_GT(errors.size(), 800U);
    const double bias =
        std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    EXPECT_LT(std::abs(bias), 0.03) << "laser " << k;
    const auto [low, high] = std::minmax_element(errors.begin(), errors.end());
    EXPECT_GT(*low, -0.15);
    EXPECT_LT(*high, 0.15);
  }
}

}  // namespace
}  // namespace dorsum
