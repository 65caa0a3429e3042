// SPDX-License-Identifier: Apache-2.0
#include "jobs/capture_checks.h"

#include <gtest/gtest.h>

#include "calibration/calibration_file.h"
#include "jobs/scan_fixture_test.h"

namespace dorsum {
namespace {

const std::vector<int> kLasers = {0, 1, 2};

CaptureImages Load(const std::string& name) {
  auto capture = LoadCapture(ScanFixture::CaptureDir(name), {}, kLasers);
  if (!capture.ok()) throw std::runtime_error(capture.error().message);
  return std::move(capture).value();
}

ReadyCalibration Ready() {
  auto calibration = ReadCalibration(ScanFixture::CalibrationJson());
  if (!calibration.ok()) throw std::runtime_error(calibration.error().message);
  return PrepareCalibration(std::move(calibration).value(), "calibration.json").value();
}

cv::Mat Dark(const CaptureImages& capture, double value = 3.0) {
  return {capture.hand.size(), CV_8UC3, cv::Scalar::all(value)};
}

TEST(CaptureChecks, AGoodCapturePasses) {
  const CaptureImages hand = Load(ScanFixture::kHand);
  const cv::Mat dark = Dark(hand);
  EXPECT_TRUE(CheckDark(dark, {}).ok());
  EXPECT_TRUE(CheckLeds(hand.hand, dark, {}).ok());
  for (const int k : kLasers) {
    EXPECT_TRUE(CheckLaser(*hand.stripes[static_cast<std::size_t>(k)], dark, k, {}).ok()) << k;
  }
  EXPECT_TRUE(CheckLasersDiffer(hand, {}).ok());
  const auto whole = CheckAgainstCalibration(hand, Ready(), {});
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  EXPECT_TRUE(whole->ok()) << whole->sentence;
}

TEST(CaptureChecks, ALightThatIsOffIsADeviceErrorWorthAnotherTry) {
  const CaptureImages hand = Load(ScanFixture::kHand);
  const cv::Mat dark = Dark(hand);
  for (const CaptureFinding& finding : {CheckLeds(dark, dark, {}), CheckLaser(dark, dark, 2, {})}) {
    EXPECT_EQ(finding.fault, CaptureFault::kTooDark);
    EXPECT_TRUE(finding.CanRetry());
    EXPECT_EQ(finding.ToError().code, ErrorCode::kDevice);
  }
  EXPECT_NE(CheckLaser(dark, dark, 2, {}).sentence.find("laser 2"), std::string::npos);
}

TEST(CaptureChecks, WhiteAndDaylitPicturesAreRefused) {
  const CaptureImages hand = Load(ScanFixture::kHand);
  const cv::Mat white = Dark(hand, 255.0);
  EXPECT_EQ(CheckLeds(white, Dark(hand), {}).fault, CaptureFault::kSaturated);
  EXPECT_EQ(CheckLaser(white, Dark(hand), 0, {}).fault, CaptureFault::kSaturated);
  EXPECT_EQ(CheckDark(hand.hand, {}).fault, CaptureFault::kDaylight);
}

TEST(CaptureChecks, OneLaserThatStandsForTwoIsSeenWithoutACalibration) {
  CaptureImages hand = Load(ScanFixture::kHand);
  hand.stripes[2] = hand.stripes[0];
  const CaptureFinding finding = CheckLasersDiffer(hand, {});
  EXPECT_EQ(finding.fault, CaptureFault::kSameLaser);
  EXPECT_NE(finding.sentence.find("0 and 2"), std::string::npos) << finding.sentence;
}

TEST(CaptureChecks, SwappedCablesAreSeenAgainstTheCalibration) {
  CaptureImages hand = Load(ScanFixture::kHand);
  std::swap(hand.stripes[0], hand.stripes[1]);
  EXPECT_TRUE(CheckLasersDiffer(hand, {}).ok());
  const auto finding = CheckAgainstCalibration(hand, Ready(), {});
  ASSERT_TRUE(finding.ok()) << finding.error().message;
  EXPECT_EQ(finding->fault, CaptureFault::kWrongLaser);
  EXPECT_NE(finding->sentence.find("laser 1 was lit in place of laser 0"), std::string::npos)
      << finding->sentence;
}

TEST(CaptureChecks, AMovedHandIsSeenAndASmallShiftOnlyTold) {
  CaptureImages hand = Load(ScanFixture::kHand);
  std::vector<std::string> warnings;
  hand.hand_after = hand.hand.clone();
  EXPECT_TRUE(CheckRest(hand, {}, &warnings).ok());
  EXPECT_TRUE(warnings.empty());
  const CaptureImages box = Load(ScanFixture::kBox);
  hand.hand_after = box.hand;
  const CaptureFinding finding = CheckRest(hand, {}, &warnings);
  EXPECT_EQ(finding.fault, CaptureFault::kMoved);
  EXPECT_TRUE(finding.CanRetry());
  EXPECT_EQ(finding.ToError().code, ErrorCode::kBadInput);
  CaptureCheckOptions lenient;
  lenient.motion_limit_px = 1e9;
  EXPECT_TRUE(CheckRest(hand, lenient, &warnings).ok());
  EXPECT_EQ(warnings.size(), 1U);
}

}  // namespace
}  // namespace dorsum
