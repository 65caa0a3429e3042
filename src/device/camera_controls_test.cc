// SPDX-License-Identifier: Apache-2.0
#include "device/camera_controls.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const int kMjpg = cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
const int kYuyv = cv::VideoWriter::fourcc('Y', 'U', 'Y', 'V');

// A webcam: each property that it has lies in a range, and a value beyond it is cut off, as drivers do.
class FakeCamera : public CameraProperties {
 public:
  struct Property {
    double value, min, max;
  };
  std::map<int, Property> has = {
      {cv::CAP_PROP_FOURCC, {double(kYuyv), 0, 1e10}},
      {cv::CAP_PROP_FRAME_WIDTH, {640, 160, 1600}},
      {cv::CAP_PROP_FRAME_HEIGHT, {480, 120, 1200}},
      {cv::CAP_PROP_AUTOFOCUS, {1, 0, 1}},
      {cv::CAP_PROP_FOCUS, {0, 0, 250}},
      {cv::CAP_PROP_AUTO_WB, {1, 0, 1}},
      {cv::CAP_PROP_WB_TEMPERATURE, {4000, 2000, 6500}},
      {cv::CAP_PROP_GAIN, {64, 0, 255}},
      {cv::CAP_PROP_AUTO_EXPOSURE, {3, 0, 3}},
      {cv::CAP_PROP_EXPOSURE, {250, 3, 2047}},
  };
  std::vector<std::pair<int, double>> order;

  bool Set(int property, double value) override {
    order.emplace_back(property, value);
    const auto found = has.find(property);
    if (found == has.end()) return false;
    // Like many webcams: no hand at a setting that the camera makes itself.
    if (property == cv::CAP_PROP_FOCUS && has.contains(cv::CAP_PROP_AUTOFOCUS) &&
        has.at(cv::CAP_PROP_AUTOFOCUS).value != 0)
      return false;
    if (property == cv::CAP_PROP_EXPOSURE && has.at(cv::CAP_PROP_AUTO_EXPOSURE).value != 1) return false;
    if (property == cv::CAP_PROP_WB_TEMPERATURE && has.at(cv::CAP_PROP_AUTO_WB).value != 0) return false;
    found->second.value = std::min(std::max(value, found->second.min), found->second.max);
    return true;
  }
  double Get(int property) const override {
    const auto found = has.find(property);
    return found == has.end() ? -1.0 : found->second.value;
  }
};

CameraDesign FullDesign() {
  CameraDesign design;
  design.laser_exposure_s = 0.004;
  design.led_exposure_s = 0.02;
  design.gain = 10;
  design.focus = 30;
  design.white_balance_k = 4600;
  return design;
}

TEST(CameraControlsTest, EverythingThatIsGivenIsSetAndAutomaticsAreOffFirst) {
  FakeCamera camera;
  const CameraDesign design = FullDesign();
  EXPECT_THAT(SetFormat(design, camera), IsEmpty());
  EXPECT_THAT(SetControls(design, camera), IsEmpty());
  EXPECT_THAT(SetExposure(design, FrameLight::kLaser, camera), IsEmpty());
  EXPECT_EQ(camera.Get(cv::CAP_PROP_EXPOSURE), 40) << "units of 100 us";
  EXPECT_THAT(SetExposure(design, FrameLight::kLeds, camera), IsEmpty());
  EXPECT_EQ(camera.Get(cv::CAP_PROP_EXPOSURE), 200);
  EXPECT_EQ(camera.Get(cv::CAP_PROP_FOURCC), kMjpg);
  EXPECT_EQ(camera.Get(cv::CAP_PROP_FRAME_WIDTH), 1600);
  EXPECT_EQ(camera.Get(cv::CAP_PROP_FRAME_HEIGHT), 1200);
  EXPECT_EQ(camera.Get(cv::CAP_PROP_AUTO_EXPOSURE), 1);
  EXPECT_EQ(camera.Get(cv::CAP_PROP_FOCUS), 30);
  EXPECT_EQ(camera.Get(cv::CAP_PROP_WB_TEMPERATURE), 4600);
  EXPECT_EQ(camera.Get(cv::CAP_PROP_GAIN), 10);
}

TEST(CameraControlsTest, NothingIsTouchedThatIsLeftAsItIs) {
  FakeCamera camera;
  const auto warnings = SetControls({}, camera);
  EXPECT_THAT(SetExposure({}, FrameLight::kLaser, camera), IsEmpty());
  EXPECT_THAT(camera.order, IsEmpty());
  EXPECT_THAT(warnings,
              ElementsAre(AllOf(HasSubstr("chooses its exposure itself"), HasSubstr("laser_exposure_s"))));
  camera.has.at(cv::CAP_PROP_AUTO_EXPOSURE).value = 1;
  EXPECT_THAT(SetControls({}, camera), IsEmpty()) << "somebody has set it by hand";
}

TEST(CameraControlsTest, WhatWasCutOffIsSaidWithBothValues) {
  FakeCamera camera;
  CameraDesign design = FullDesign();
  design.laser_exposure_s = 0.5;
  design.gain = 300;
  design.width = 1920;
  EXPECT_THAT(SetFormat(design, camera),
              ElementsAre(AllOf(HasSubstr("resolution 1920x1200"), HasSubstr("1600x1200"))));
  EXPECT_THAT(SetControls(design, camera), ElementsAre(AllOf(HasSubstr("gain 300"), HasSubstr("it is 255"))));
  EXPECT_THAT(SetExposure(design, FrameLight::kLaser, camera),
              ElementsAre(AllOf(HasSubstr("exposure for lasers of 0.5 s"), HasSubstr("it is 0.2047 s"))));
}

TEST(CameraControlsTest, ControlThatTheCameraLacksIsSaid) {
  FakeCamera camera;
  camera.has.erase(cv::CAP_PROP_FOCUS);
  camera.has.erase(cv::CAP_PROP_AUTOFOCUS);
  EXPECT_THAT(SetControls(FullDesign(), camera),
              ElementsAre(AllOf(HasSubstr("focus 30"), HasSubstr("no such control"))));
}

TEST(CameraControlsTest, StreamFormatThatIsNotTakenIsSaid) {
  FakeCamera camera;
  camera.has.at(cv::CAP_PROP_FOURCC) = {double(kYuyv), double(kYuyv), double(kYuyv)};
  EXPECT_THAT(SetFormat({}, camera), ElementsAre(AllOf(HasSubstr("stream format mjpeg"), HasSubstr("YUYV"))));
  CameraDesign raw;
  raw.stream_format = "raw";
  EXPECT_THAT(SetFormat(raw, camera), IsEmpty());
  camera.has.at(cv::CAP_PROP_FOURCC) = {double(kMjpg), double(kMjpg), double(kMjpg)};
  EXPECT_THAT(SetFormat(raw, camera), ElementsAre(AllOf(HasSubstr("stream format raw"), HasSubstr("MJPG"))));
}

}  // namespace
}  // namespace dorsum
