// SPDX-License-Identifier: Apache-2.0
#include "simulator/renderer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "simulator/named_scene.h"
#include "simulator/small_device_test.h"
#include "simulator/truth.h"

namespace dorsum {
namespace {

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

struct Pictures {
  cv::Mat leds, laser, dark;
  std::vector<TrueStripePoint> stripes;
};

Pictures Render(const VirtualDevice& device, const std::string& scene, std::uint64_t seed, int threads) {
  Context context;
  context.threads = threads;
  const auto name = ParseSceneName(scene);
  const auto stage = SetStage(device, BuildNamedScene(device, *name, 1, 1), context);
  EXPECT_TRUE(stage.ok());
  return {*RenderLeds(device, *stage, seed, context), *RenderLaser(device, *stage, 0, seed, context),
          *RenderDark(device, *stage, seed, context), *TrueStripes(device, *stage, 0, context)};
}

TEST(Renderer, SameSeedSameBytesAtAnyNumberOfThreads) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 6);
  for (const char* scene : {"box25.5", "sphere25"}) {
    const Pictures one = Render(device, scene, 9, 1), two = Render(device, scene, 9, 2);
    EXPECT_TRUE(SameBytes(one.leds, two.leds)) << scene;
    EXPECT_TRUE(SameBytes(one.laser, two.laser)) << scene;
    EXPECT_TRUE(SameBytes(one.dark, two.dark)) << scene;
    ASSERT_EQ(one.stripes.size(), two.stripes.size());
    for (std::size_t i = 0; i < one.stripes.size(); ++i) EXPECT_EQ(one.stripes[i].u, two.stripes[i].u);
  }
}

TEST(Renderer, AnotherSeedIsAnotherNoise) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 6);
  const Pictures a = Render(device, "box25.5", 9, 0), b = Render(device, "box25.5", 10, 0);
  EXPECT_FALSE(SameBytes(a.leds, b.leds));
  EXPECT_FALSE(SameBytes(a.laser, b.laser));
  ASSERT_EQ(a.stripes.size(), b.stripes.size()) << "the scene is the same";
}

TEST(Renderer, LightLevelsAreThoseOfTheDescription) {
  DeviceDescription d = WithoutNoise(CoarseDevice());
  d.sensor.filter_falloff = 0.0;
  const VirtualDevice device = BuildVirtualDevice(d, 1);
  const Pictures pictures = Render(device, "plane", 1, 0);
  const Eigen::Vector2d middle = Project(device.camera, Eigen::Vector3d::Zero());
  const auto pixel = pictures.leds.at<cv::Vec3b>(static_cast<int>(middle.y()), static_cast<int>(middle.x()));
  const double white = 0.82 * (3.0 * 0.28 + d.light.ambient_led);
  EXPECT_NEAR(pixel[1], 255.0 * white, 8.0);
  EXPECT_NEAR(pixel[0], pixel[1] * d.sensor.leak_blue, 1.5);
  EXPECT_NEAR(pixel[2], pixel[1] * d.sensor.leak_red, 1.5);
  EXPECT_EQ(pictures.dark.at<cv::Vec3b>(static_cast<int>(middle.y()), static_cast<int>(middle.x()))[1], 0);
}

TEST(Renderer, ABoxThrowsASoftShadowUnderTheLeds) {
  const VirtualDevice device = BuildVirtualDevice(WithoutNoise(CoarseDevice()), 1);
  BoxPlace box;
  box.centre_mm = {0.0, 0.0};
  box.height_mm = 40.0;
  Scene scene, empty;
  scene.parts = {Backplane(), BrownBox(box)};
  empty.parts = {Backplane()};
  const auto with = SetStage(device, scene, Context{}), without = SetStage(device, empty, Context{});
  ASSERT_TRUE(with.ok() && without.ok());
  const cv::Mat a = *RenderLeds(device, *with, 1, Context{}), b = *RenderLeds(device, *without, 1, Context{});
  int near_dark = 0, half = 0, far_changed = 0;
  for (int v = 0; v < a.rows; ++v) {
    for (int u = 0; u < a.cols; ++u) {
      const SurfaceSample& sample = with->view.At(u, v);
      if (sample.material != Material::kBackplane) continue;
      const double ratio = (a.at<cv::Vec3b>(v, u)[1] + 1.0) / (b.at<cv::Vec3b>(v, u)[1] + 1.0);
      const double outside =
          std::max(std::abs(sample.position.x()) - 40.0, std::abs(sample.position.y()) - 30.0);
      if (outside > 60.0) far_changed += std::abs(ratio - 1.0) > 0.02;
      if (outside > 2.0 && outside < 10.0) near_dark += ratio < 0.75;
      if (outside > 2.0) half += ratio > 0.8 && ratio < 0.95;
    }
  }
  EXPECT_GT(near_dark, 50);
  EXPECT_GT(half, 50) << "the shadow's rim is soft";
  EXPECT_EQ(far_changed, 0);
}

TEST(Renderer, StopsWhenCancelled) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 1);
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  Scene scene;
  scene.parts = {Backplane()};
  const auto stage = SetStage(device, scene, context);
  ASSERT_FALSE(stage.ok());
  EXPECT_EQ(stage.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
