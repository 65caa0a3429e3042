// SPDX-License-Identifier: Apache-2.0
#include "jobs/capture.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "captures/capture.h"
#include "device/device_error.h"
#include "device/hooked_device_test.h"
#include "jobs/virtual_device_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class CaptureTest : public ::testing::Test {
 protected:
  CaptureTest() : device_(OpenFixtureDevice(dir_)), hooks_(Hook(device_)) {
    request_.out_dir = dir_ / "capture";
    Place("box25.5");
  }

  void Place(const std::string& scene) { ASSERT_TRUE(device_.bench->PlaceNamed(scene).ok()); }
  Result<CaptureSummary> Capture(const Context& context = {}) {
    return CaptureToFolder(device_, request_, context);
  }
  // After any failure: nothing written, and nothing lit.
  void ExpectCleanFailure(const Result<CaptureSummary>& result, ErrorCode code) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, code) << result.error().message;
    EXPECT_GT(result.error().message.size(), code == ErrorCode::kCancelled ? 0U : 20U);
    EXPECT_TRUE(device_.bench->On().none());
    for (const auto& entry : fs::directory_iterator(dir_.path())) {
      EXPECT_EQ(entry.path().filename(), "device.toml");
    }
  }

  TempFolder dir_;
  Device device_;
  std::shared_ptr<DeviceHooks> hooks_;
  CaptureRequest request_;
};

TEST_F(CaptureTest, AWholeCaptureIsWrittenAndTheLightsAreOff) {
  Place("hand:woman:right:anna");
  request_.calibration_path = ScanFixture::CalibrationJson();
  const auto summary = Capture();
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(summary->files.size(), 5U);
  EXPECT_EQ(summary->retried, 0);
  EXPECT_TRUE(summary->warnings.empty()) << summary->warnings.front();
  EXPECT_TRUE(device_.bench->On().none());
  const auto back = LoadCapture(request_.out_dir, {560, 420}, {0, 1, 2});
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_TRUE(back->hand_after.has_value());
  EXPECT_TRUE(back->warnings.empty());
}

TEST_F(CaptureTest, WithoutACalibrationItIsSaidWhatCannotBeTold) {
  const auto summary = Capture();
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->warnings.size(), 1U);
}

TEST_F(CaptureTest, OnlyTheLasersThatAreAskedForAreLit) {
  request_.lasers = {2, 0};
  const auto summary = Capture();
  ASSERT_TRUE(summary.ok());
  EXPECT_FALSE(fs::exists(request_.out_dir / "stripesHand1.png"));
  EXPECT_TRUE(fs::exists(request_.out_dir / "stripesHand2.png"));
  request_.lasers = {3};
  request_.out_dir = dir_ / "other";
  EXPECT_EQ(Capture().error().code, ErrorCode::kUsage);
}

TEST_F(CaptureTest, AnAverageHasLessNoise) {
  request_.average = 8;
  ASSERT_TRUE(Capture().ok());
  EXPECT_GE(hooks_->frames, 6 * 8);
}

TEST_F(CaptureTest, AHandThatMovedIsCapturedOnceMore) {
  Place("box25.5+moved3");
  const auto summary = Capture();
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(summary->retried, 1);
}

TEST_F(CaptureTest, AHandThatMovesWithoutTriesLeftIsRefused) {
  Place("box25.5+moved3");
  request_.retries = 0;
  ExpectCleanFailure(Capture(), ErrorCode::kBadInput);
}

TEST_F(CaptureTest, ADarkLaserIsADeviceErrorAfterItsTries) {
  Place("box25.5+off1");
  const auto result = Capture();
  ExpectCleanFailure(result, ErrorCode::kDevice);
  EXPECT_NE(result.error().message.find("laser 1"), std::string::npos);
}

TEST_F(CaptureTest, AnEmptyBackplaneGivesNoCapture) {
  Place("plane");
  request_.calibration_path = ScanFixture::CalibrationJson();
  ExpectCleanFailure(Capture(), ErrorCode::kBadInput);
}

TEST_F(CaptureTest, AnObjectThatLeavesThePictureOnTwoSidesIsCut) {
  BoxPlace bar;
  bar.size_mm = {600.0, 50.0};
  Scene scene;
  scene.parts = {Backplane(), BrownBox(bar)};
  device_.bench->Place(std::move(scene), "bar");
  request_.calibration_path = ScanFixture::CalibrationJson();
  const auto result = Capture();
  ExpectCleanFailure(result, ErrorCode::kBadInput);
  EXPECT_NE(result.error().message.find("more than one place"), std::string::npos) << result.error().message;
}

TEST_F(CaptureTest, ACameraThatGoesAtAnyStepLeavesNothingBehind) {
  ASSERT_TRUE(Capture().ok());
  const int frames = hooks_->frames;
  fs::remove_all(request_.out_dir);
  for (int broken = 0; broken < frames; ++broken) {
    hooks_->frames = 0;
    hooks_->frame = [&](int call, Result<Frame> frame) -> Result<Frame> {
      if (call < broken) return frame;
      return DeviceError("the camera is gone; plug it in again");
    };
    ExpectCleanFailure(Capture(), ErrorCode::kDevice);
  }
}

TEST_F(CaptureTest, AControllerThatGoesAtAnyStepLeavesNothingBehind) {
  ASSERT_TRUE(Capture().ok());
  const int sets = hooks_->sets;
  fs::remove_all(request_.out_dir);
  for (int broken = 0; broken < sets; ++broken) {
    hooks_->sets = 0;
    hooks_->set = [&](int call, const ChannelSet&) -> Status {
      if (call < broken) return {};
      return DeviceError("the light controller does not answer; check its cable");
    };
    ExpectCleanFailure(Capture(), ErrorCode::kDevice);
  }
}

TEST_F(CaptureTest, ALightThatTheControllerSwitchedOffGivesNoPicture) {
  for (int step = 1; step < 6; ++step) {
    hooks_->queries = 0;
    hooks_->on = [&](int call, ChannelSet on) -> Result<ChannelSet> {
      return call == step ? ChannelSet() : on;
    };
    ExpectCleanFailure(Capture(), ErrorCode::kDevice);
  }
}

TEST_F(CaptureTest, AFrozenCameraIsNotTakenForALitScene) {
  Frame first;
  hooks_->frame = [&](int call, Result<Frame> frame) -> Result<Frame> {
    if (call == 0) first = *frame;
    Frame same = *frame;
    same.image = first.image;
    return same;
  };
  ExpectCleanFailure(Capture(), ErrorCode::kDevice);
}

TEST_F(CaptureTest, AnInterruptAtAnyPictureLeavesNothingBehind) {
  for (int step = 0; step < 6; ++step) {
    std::atomic<bool> cancel{false};
    Context context;
    context.cancel = &cancel;
    hooks_->sets = 0;
    hooks_->set = [&](int call, const ChannelSet&) -> Status {
      if (call == step) cancel = true;
      return {};
    };
    ExpectCleanFailure(Capture(context), ErrorCode::kCancelled);
  }
}

TEST_F(CaptureTest, AFolderThatIsInUseIsNotTouched) {
  fs::create_directories(request_.out_dir);
  ASSERT_TRUE(WriteFile(request_.out_dir / "mine.txt", "x").ok());
  const auto result = Capture();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(hooks_->sets, 0);
}

TEST_F(CaptureTest, NowhereToWriteIsSaidAndTheLightsAreOff) {
  request_.out_dir = "/proc/nowhere/capture";
  const auto result = Capture();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(device_.bench->On().none());
}

TEST_F(CaptureTest, ACalibrationOfAnotherResolutionIsRefusedBeforeAnyLight) {
  device_.description.camera.width = 800;
  request_.calibration_path = ScanFixture::CalibrationJson();
  const auto result = Capture();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(hooks_->sets, 0);
}

}  // namespace
}  // namespace dorsum
