// SPDX-License-Identifier: Apache-2.0
#include "studio/scan_model.h"

#include "captures/capture.h"
#include "studio/scan_fixture_studio_test.h"

namespace dorsum {
namespace {

class ScanModelTest : public ScanTest {
 protected:
  ScanModelTest() : model_(&workbench_) { Prepare(&model_); }
  void Ready(const char* scene) {
    Calibrate();
    OpenDeviceOf(&model_);
    model_.Place(scene);
  }
  ScanModel model_;
};

TEST_F(ScanModelTest, AHandThatRestsIsScannedByItselfRepeatedAndKept) {
  Ready("hand:woman:right:anna");
  ASSERT_TRUE(Reaches(model_, ScanState::kReady)) << model_.Sentence().toStdString();
  EXPECT_EQ(model_.Sentence(), "Good: hold still");
  model_.SetAutomatic(true);
  EXPECT_EQ(model_.state(), ScanState::kCapturing);
  ASSERT_TRUE(Reaches(model_, ScanState::kShown)) << error_.value_or(Error{}).message;
  EXPECT_EQ(model_.steps_done(), 7);
  ASSERT_EQ(model_.fingers().size(), 5U);
  for (const FingerQuality& finger : model_.fingers()) {
    EXPECT_GT(finger.covered, 0.5);
    EXPECT_GT(finger.sigma_mm, 0.0);
    EXPECT_LT(finger.sigma_mm, 1.0);
    std::printf("[ figure ] finger: %.0f %% covered, %.3f mm\n", 100.0 * finger.covered, finger.sigma_mm);
  }
  // Besides the computation, only the judging of the fingers and the way into the window.
  std::printf("[ figure ] surface after %.2f s, computed in %.2f s\n", model_.wait_s(),
              model_.taken()->seconds);
  EXPECT_LT(model_.wait_s(), 2.0 * model_.taken()->seconds + 0.5);

  // The same hand, which has not moved, is not scanned again by itself.
  model_.Repeat();
  ASSERT_TRUE(Reaches(model_, ScanState::kReady));
  QTest::qWait(300);
  EXPECT_EQ(model_.state(), ScanState::kReady)
      << model_.Sentence().toStdString() << ", rested for " << model_.view().rested_s << " s";
  model_.Scan();
  ASSERT_TRUE(Reaches(model_, ScanState::kShown));
  QSignalSpy kept(&model_, &ScanModel::Kept);
  model_.Keep();
  ASSERT_TRUE(kept.wait(kPatience_ms));
  EXPECT_EQ(model_.state(), ScanState::kKept);
  const std::filesystem::path folder = workbench_.scan()->folder;
  EXPECT_EQ(folder.parent_path(), dir_ / "kept");
  const auto capture = LoadCapture(folder, {560, 420}, {0, 1, 2});
  ASSERT_TRUE(capture.ok()) << capture.error().message;
  EXPECT_TRUE(capture->hand_after.has_value());
  EXPECT_FALSE(error_.has_value());
}

TEST_F(ScanModelTest, AnEmptyBackplaneIsNeverReadyAndAScanOfItIsRefusedInASentence) {
  Ready("plane");
  QSignalSpy viewed(&model_, &ScanModel::ViewChanged);
  ASSERT_TRUE(viewed.wait(kPatience_ms));
  EXPECT_EQ(model_.Sentence(), "Put your hand down");
  model_.Scan();
  ASSERT_TRUE(QTest::qWaitFor([&] { return error_.has_value(); }, kPatience_ms));
  EXPECT_EQ(model_.state(), ScanState::kPreview);
}

TEST_F(ScanModelTest, AHandThatMovesIsRefusedAndTheLivePictureComesBack) {
  Ready("hand:woman:right:anna+moved1");
  ASSERT_TRUE(Reaches(model_, ScanState::kReady));
  model_.Scan();
  ASSERT_TRUE(QTest::qWaitFor([&] { return error_.has_value(); }, kPatience_ms));
  EXPECT_EQ(error_->code, ErrorCode::kBadInput);
  EXPECT_NE(error_->message.find("moved"), std::string::npos) << error_->message;
  EXPECT_EQ(model_.state(), ScanState::kPreview);
  EXPECT_EQ(workbench_.scan(), nullptr);
}

TEST_F(ScanModelTest, ADeviceThatGoesInTheMiddleIsSaidAndCanBeConnectedAgain) {
  Ready("hand:woman:right:anna");
  ASSERT_TRUE(Reaches(model_, ScanState::kReady));
  WithHooks([](DeviceHooks& hooks) {
    hooks.set = [](int, const ChannelSet& on) {
      return on.test(1) ? Status(Error{ErrorCode::kDevice, "the controller is gone; plug it in"}) : Status();
    };
  });
  ASSERT_TRUE(Reaches(model_, ScanState::kReady));
  model_.Scan();
  ASSERT_TRUE(Reaches(model_, ScanState::kLost));
  ASSERT_TRUE(error_.has_value());
  EXPECT_EQ(error_->code, ErrorCode::kDevice);
  model_.Reconnect();
  EXPECT_TRUE(Reaches(model_, ScanState::kPreview));
}

TEST_F(ScanModelTest, ACameraThatGoesInTheLivePictureIsSaid) {
  Ready("plane");
  WithHooks([](DeviceHooks& hooks) {
    hooks.frame = [](int, const Result<Frame>&) { return Result<Frame>(Error{ErrorCode::kDevice, "gone"}); };
  });
  EXPECT_TRUE(Reaches(model_, ScanState::kLost));
}

TEST_F(ScanModelTest, AScanThatIsCancelledLeavesTheLivePicture) {
  Ready("hand:woman:right:anna");
  ASSERT_TRUE(Reaches(model_, ScanState::kReady));
  model_.Scan();
  ASSERT_TRUE(QTest::qWaitFor([&] { return model_.steps_done() > 1; }, kPatience_ms));
  model_.Cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return error_.has_value(); }, kPatience_ms));
  EXPECT_EQ(error_->code, ErrorCode::kCancelled);
  EXPECT_EQ(model_.state(), ScanState::kPreview);
  EXPECT_EQ(workbench_.scan(), nullptr);
}

TEST_F(ScanModelTest, AFolderThatCannotBeWrittenLosesNoScan) {
  Ready("hand:woman:right:anna");
  ASSERT_TRUE(Reaches(model_, ScanState::kReady));
  model_.Scan();
  ASSERT_TRUE(Reaches(model_, ScanState::kShown));
  ASSERT_TRUE(WriteFile(dir_ / "file", "").ok());
  model_.SetFolder(dir_ / "file");
  model_.Keep();
  ASSERT_TRUE(QTest::qWaitFor([&] { return error_.has_value(); }, kPatience_ms));
  EXPECT_EQ(model_.state(), ScanState::kShown);
  QSignalSpy kept(&model_, &ScanModel::Kept);
  model_.SetFolder(dir_ / "kept");
  model_.Keep();
  EXPECT_TRUE(kept.wait(kPatience_ms));
}

TEST_F(ScanModelTest, AVirtualDeviceWithoutACalibrationMakesItsOwnAndTakesItTheNextTime) {
  OpenDeviceOf(&model_);
  EXPECT_EQ(model_.state(), ScanState::kNoCalibration);
  model_.Scan();
  EXPECT_EQ(model_.state(), ScanState::kNoCalibration);
  model_.CalibrateVirtual();
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.device().busy(); }, kPatience_ms));
  QTest::qWait(200);
  model_.Cancel();
  ASSERT_TRUE(Reaches(model_, ScanState::kNoCalibration));
  QSignalSpy changed(&workbench_, &Workbench::CalibrationChanged);
  model_.CalibrateVirtual();
  ASSERT_TRUE(changed.wait(kPatience_ms)) << error_.value_or(Error{}).message;
  EXPECT_TRUE(Reaches(model_, ScanState::kPreview));

  Workbench other;
  ScanModel again(&other);
  again.SetCache(dir_ / "cache");
  again.Activate();
  other.device().Open((dir_ / "device.toml").string());
  EXPECT_TRUE(Reaches(again, ScanState::kPreview));
}

}  // namespace
}  // namespace dorsum
