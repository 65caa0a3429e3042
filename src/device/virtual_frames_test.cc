// SPDX-License-Identifier: Apache-2.0
#include "device/virtual_frames.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "device/device.h"

namespace dorsum {
namespace {

class VirtualFramesTest : public ::testing::Test {
 protected:
  static DeviceDescription Small() {
    DeviceDescription d = DefaultDevice();
    d.camera.width = 320;
    d.camera.height = 240;
    d.camera.focal_length_px = 416.0;
    return d;
  }
  VirtualFramesTest()
      : bench_(std::make_shared<VirtualBench>(Small(), "1", 1)),
        frames_(MakeVirtualFrames(bench_)),
        lights_(MakeVirtualLights(bench_)) {}

  cv::Mat Green() {
    const auto frame = frames_->Next(1.0);
    EXPECT_TRUE(frame.ok());
    cv::Mat green;
    cv::extractChannel(frame->image, green, 1);
    return green;
  }
  double Mean(const ChannelSet& on) {
    EXPECT_TRUE(lights_->Set(on).ok());
    return cv::mean(Green())[0];
  }

  std::shared_ptr<VirtualBench> bench_;
  std::unique_ptr<FrameSource> frames_;
  std::unique_ptr<Lights> lights_;
};

TEST_F(VirtualFramesTest, TheCameraSeesTheLightsThatAreOn) {
  const DeviceDescription& d = bench_->device().description;
  const double dark = Mean({}), leds = Mean(LedChannels(d)), laser = Mean(LaserChannel(d, 1));
  EXPECT_LT(dark, 10.0);
  EXPECT_GT(leds, 50.0);
  EXPECT_GT(laser, dark + 3.0);
  EXPECT_GT(Mean(LaserChannel(d, 0) | LaserChannel(d, 1)), laser + 3.0);
  EXPECT_EQ(*lights_->On(), LaserChannel(d, 0) | LaserChannel(d, 1));
}

TEST_F(VirtualFramesTest, FramesDifferByNoiseAlone) {
  ASSERT_TRUE(lights_->Set(LaserChannel(bench_->device().description, 1)).ok());
  const cv::Mat a = Green(), b = Green();
  EXPECT_GT(cv::norm(a, b, cv::NORM_INF), 0.0);
  // Speckle stands still while nothing moves: what differs is far below what speckle does to a stripe.
  EXPECT_LT(cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total()), 2.5);
}

TEST_F(VirtualFramesTest, TheLightsGoOffWithWhoHoldsThem) {
  ASSERT_TRUE(lights_->Set(LedChannels(bench_->device().description)).ok());
  lights_.reset();
  EXPECT_TRUE(bench_->On().none());
}

TEST_F(VirtualFramesTest, AnObjectThatMovesDoesSoUnderItsLaserAndStays) {
  const DeviceDescription& d = bench_->device().description;
  ASSERT_TRUE(bench_->PlaceNamed("box25.5+moved8").ok());
  ASSERT_TRUE(lights_->Set(LedChannels(d)).ok());
  const cv::Mat before = Green();
  for (int k = 0; k < 4; ++k) ASSERT_TRUE(lights_->Set(LaserChannel(d, k)).ok());
  ASSERT_TRUE(lights_->Set(LedChannels(d)).ok());
  const cv::Mat after = Green(), again = Green();
  const auto changed = [](const cv::Mat& a, const cv::Mat& b) {
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    return cv::countNonZero(difference > 30);
  };
  EXPECT_GT(changed(before, after), 50);
  EXPECT_LT(changed(after, again), 5);
}

TEST_F(VirtualFramesTest, ASceneThatDoesNotExistIsWrongUsage) {
  EXPECT_EQ(bench_->PlaceNamed("teapot").error().code, ErrorCode::kUsage);
  EXPECT_EQ(bench_->PlaceNamed("box25.5+off9").ok(), false);
}

}  // namespace
}  // namespace dorsum
