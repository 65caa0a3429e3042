// SPDX-License-Identifier: Apache-2.0
// OpenVideoFrames() on a Video4Linux camera, through VideoCapture's own code.
#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "base/temp_folder_test.h"
#include "device/fake_v4l2_test.h"
#include "device/mjpeg_server_test.h"
#include "device/still_picture.h"
#include "device/video_frames.h"
#include "device/video_pictures_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string GreyJpeg(int level, int seed) { return JpegOf(GreyPicture(level, seed)); }

class CameraFramesTest : public ::testing::Test {
 protected:
  CameraFramesTest() : camera_(dir_.path(), [this](int frame) { return paint_(frame); }) {
    camera_.controls = {{V4L2_CID_EXPOSURE_AUTO, {V4L2_EXPOSURE_APERTURE_PRIORITY, 0, 3}},
                        {V4L2_CID_EXPOSURE_ABSOLUTE, {250, 3, 2047}},
                        {V4L2_CID_GAIN, {64, 0, 255}},
                        {V4L2_CID_FOCUS_AUTO, {1, 0, 1}},
                        {V4L2_CID_FOCUS_ABSOLUTE, {0, 0, 250}},
                        {V4L2_CID_AUTO_WHITE_BALANCE, {1, 0, 1}},
                        {V4L2_CID_WHITE_BALANCE_TEMPERATURE, {4000, 2000, 6500}}};
    design_.laser_exposure_s = 0.004;
    design_.led_exposure_s = 0.02;
    design_.gain = 10;
    design_.focus = 30;
    design_.white_balance_k = 4600;
  }

  Result<std::unique_ptr<FrameSource>> Open(VideoLimits limits = {5.0, 2.0}) {
    return OpenVideoFrames(VideoKind::kCamera, camera_.device(), design_, limits, {});
  }
  int ControlValue(std::uint32_t id) {
    const std::lock_guard lock(camera_.mutex);
    return camera_.controls.at(id).value;
  }
  TempFolder dir_;
  std::function<std::string(int)> paint_ = [](int frame) { return GreyJpeg(20 + frame % 200, frame); };
  FakeV4l2 camera_;
  CameraDesign design_ = VideoDesign();
};

TEST_F(CameraFramesTest, SettingsReachTheDriverAndFramesCome) {
  auto frames = Open();
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  EXPECT_THAT((*frames)->warnings(), IsEmpty());
  EXPECT_EQ(ControlValue(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(ControlValue(V4L2_CID_GAIN), 10);
  EXPECT_EQ(ControlValue(V4L2_CID_FOCUS_AUTO), 0);
  EXPECT_EQ(ControlValue(V4L2_CID_FOCUS_ABSOLUTE), 30);
  EXPECT_EQ(ControlValue(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(ControlValue(V4L2_CID_WHITE_BALANCE_TEMPERATURE), 4600);
  ASSERT_TRUE((*frames)->ExposeFor(FrameLight::kLaser).ok());
  EXPECT_EQ(ControlValue(V4L2_CID_EXPOSURE_ABSOLUTE), 40) << "units of 100 us";
  ASSERT_TRUE((*frames)->ExposeFor(FrameLight::kLeds).ok());
  EXPECT_EQ(ControlValue(V4L2_CID_EXPOSURE_ABSOLUTE), 200);
  double level = 0.0;
  for (int i = 0; i < 10; ++i) {
    const auto frame = (*frames)->Next(10.0);
    ASSERT_TRUE(frame.ok()) << frame.error().message;
    EXPECT_GT(cv::mean(frame->image)[1], level) << "none twice and none older";
    level = cv::mean(frame->image)[1] + 0.5;
  }
  EXPECT_THAT((*frames)->warnings(), IsEmpty());
  EXPECT_TRUE((*frames)->never_repeats());
}

TEST_F(CameraFramesTest, ExposureThatComesLateIsNotTakenForSettled) {
  // As webcams do: an exposure is seen three frames after it was set, while the light changes at once.
  double light = 0.3;
  std::vector<int> exposures;
  paint_ = [&](int frame) {  // called with the mutex held
    exposures.push_back(camera_.controls.at(V4L2_CID_EXPOSURE_ABSOLUTE).value);
    const int exposure = exposures.size() > 3 ? exposures[exposures.size() - 4] : 250;
    return GreyJpeg(std::min(250, static_cast<int>(light * exposure)), frame);
  };
  camera_.interval_s = 0.01;
  auto frames = Open();
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  for (const auto& [next, level, which] : {std::tuple{4.0, 160, FrameLight::kLaser},
                                           {0.3, 60, FrameLight::kLeds},
                                           {3.0, 120, FrameLight::kLaser},
                                           {2.0, 80, FrameLight::kLaser}}) {
    ASSERT_TRUE((*frames)->ExposeFor(which).ok());
    {
      const std::lock_guard lock(camera_.mutex);
      light = next;
    }
    StillOptions options;
    options.delay_s = 0.0;
    options.timeout_s = 60.0;
    const auto still = TakeStill(**frames, MonotonicSeconds(), options, {});
    ASSERT_TRUE(still.ok()) << still.error().message;
    EXPECT_NEAR(cv::mean(*still)[1], level, 2.0);
  }
}

TEST_F(CameraFramesTest, StampsAreTheDriversUnlessItsClockIsAnother) {
  camera_.exposed_before_s = 1.0;
  {
    auto frames = Open();
    ASSERT_TRUE(frames.ok()) << frames.error().message;
    const auto frame = (*frames)->Next(10.0);
    ASSERT_TRUE(frame.ok());
    EXPECT_LE(frame->time_s, MonotonicSeconds() - 1.0);
  }
  camera_.foreign_clock = true;
  const double start_s = MonotonicSeconds();
  auto frames = Open();
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  const auto frame = (*frames)->Next(10.0);
  ASSERT_TRUE(frame.ok());
  EXPECT_GE(frame->time_s, start_s) << "its arrival";
}

TEST_F(CameraFramesTest, SettingsThatAreNotTakenAreWarnings) {
  camera_.controls.erase(V4L2_CID_FOCUS_ABSOLUTE);
  camera_.controls.at(V4L2_CID_GAIN).max = 5;
  design_.laser_exposure_s = 1.0;
  auto frames = Open();
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  EXPECT_TRUE((*frames)->ExposeFor(FrameLight::kLaser).ok()) << "a warning, no error";
  EXPECT_TRUE((*frames)->ExposeFor(FrameLight::kLaser).ok());
  EXPECT_THAT((*frames)->warnings(),
              ::testing::ElementsAre(AllOf(HasSubstr("focus 30"), HasSubstr("no such control")),
                                     AllOf(HasSubstr("gain 10"), HasSubstr("it is 5")),
                                     AllOf(HasSubstr("exposure for lasers of 1 s"), HasSubstr("0.2047 s"))));
}

TEST_F(CameraFramesTest, RawPicturesAreConverted) {
  design_.stream_format = "raw";
  paint_ = [](int) {  // YUYV: mid grey with full-scale blue difference left at its middle
    std::string bytes;
    for (int i = 0; i < kVideoSize.area(); ++i) bytes += {static_cast<char>(126), static_cast<char>(128)};
    return bytes;
  };
  auto frames = Open();
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  const auto frame = (*frames)->Next(10.0);
  ASSERT_TRUE(frame.ok());
  EXPECT_EQ(frame->image.type(), CV_8UC3);
  EXPECT_EQ(frame->image.size(), kVideoSize);
  EXPECT_NEAR(cv::mean(frame->image)[1], (126 - 16) * 1.164, 1.5);
}

TEST_F(CameraFramesTest, ResolutionThatTheCameraLacksIsAnErrorThatNamesItsOwn) {
  design_.width = 1600;
  design_.height = 1200;
  const auto frames = Open();
  ASSERT_FALSE(frames.ok());
  EXPECT_EQ(frames.error().code, ErrorCode::kDevice);
  EXPECT_THAT(frames.error().message,
              AllOf(HasSubstr("320x240"), HasSubstr("1600x1200"), HasSubstr("resolution_px")));
}

TEST_F(CameraFramesTest, CameraThatIsUnpluggedIsGone) {
  auto frames = Open();
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  ASSERT_TRUE((*frames)->Next(10.0).ok());
  {
    const std::lock_guard lock(camera_.mutex);
    camera_.gone = true;
  }
  const Error error = ErrorAtTheEnd(**frames);
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  EXPECT_THAT(error.message, AllOf(HasSubstr(camera_.device()), HasSubstr("is gone")));
  EXPECT_EQ((*frames)->ExposeFor(FrameLight::kLeds).error().code, ErrorCode::kDevice);
}

TEST_F(CameraFramesTest, CameraThatFallsSilentIsAnErrorInTime) {
  auto frames = Open({5.0, 0.3});
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  {
    const std::lock_guard lock(camera_.mutex);
    camera_.silent = true;
  }
  EXPECT_THAT(ErrorAtTheEnd(**frames).message, HasSubstr("stopped sending pictures"));
}

TEST_F(CameraFramesTest, DamagedPicturesOfACameraArePassedOver) {
  paint_ = [](int frame) {
    std::string jpeg = GreyJpeg(100, frame);
    if (frame % 2 == 1) jpeg.resize(jpeg.size() / 3);
    return jpeg + std::string(frame % 3 == 0 ? 500 : 0, '\0');  // padding is no damage
  };
  auto frames = Open();
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  for (int i = 0; i < 6; ++i) {
    const auto frame = (*frames)->Next(10.0);
    ASSERT_TRUE(frame.ok()) << frame.error().message;
    EXPECT_NEAR(cv::mean(frame->image)[1], 100.0, 1.0);
  }
}

}  // namespace
}  // namespace dorsum
