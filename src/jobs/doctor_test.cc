// SPDX-License-Identifier: Apache-2.0
#include "jobs/doctor.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "device/device_error.h"
#include "device/hooked_device_test.h"
#include "jobs/doctor_pictures.h"
#include "jobs/virtual_device_test.h"

namespace dorsum {
namespace {

using Health = DoctorFinding::Health;

std::vector<DoctorFinding> Broken(const std::vector<DoctorFinding>& findings) {
  std::vector<DoctorFinding> broken;
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(broken),
               [](const DoctorFinding& f) { return f.health == Health::kBroken; });
  return broken;
}

ReadyCalibration Ready() {
  return PrepareCalibration(ReadCalibration(ScanFixture::CalibrationJson()).value(), "calibration.json")
      .value();
}

class DoctorTest : public ::testing::Test {
 protected:
  DoctorTest() : device_(OpenFixtureDevice(dir_)) {}
  std::vector<DoctorFinding> Look(const ReadyCalibration* calibration = nullptr) {
    std::vector<DoctorFinding> findings;
    EXPECT_TRUE(LookAtPictures(device_, calibration, {}, &findings).ok());
    EXPECT_TRUE(device_.bench->On().none());
    return findings;
  }
  TempFolder dir_;
  Device device_;
};

TEST_F(DoctorTest, ASoundDeviceThatFitsItsCalibrationIsHealthy) {
  DoctorRequest request;
  request.device = (dir_ / "device.toml").string();
  request.calibration_path = ScanFixture::CalibrationJson();
  request.data_dir = dir_.path();
  request.min_free_gb = 0.0;
  const auto report = ExamineDevice(request, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->healthy()) << DoctorReportToText(*report);
  int fitting = 0;
  for (const DoctorFinding& f : report->findings) {
    fitting += f.sentence.find("from where the calibration has them") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(fitting, 3) << DoctorReportToText(*report);
  EXPECT_TRUE(DoctorReportToJson(*report)["healthy"].get<bool>());
}

TEST_F(DoctorTest, AKnockedCameraIsFoundByEachLaser) {
  ASSERT_TRUE(device_.bench->PlaceNamed("plane+knocked1").ok());
  const ReadyCalibration ready = Ready();
  const auto broken = Broken(Look(&ready));
  ASSERT_EQ(broken.size(), 3U);
  for (const DoctorFinding& f : broken) EXPECT_NE(f.remedy.find("calibrate again"), std::string::npos);
}

TEST_F(DoctorTest, ADarkLaserIsNamedAndTheOthersAreStillLookedAt) {
  ASSERT_TRUE(device_.bench->PlaceNamed("plane+off1").ok());
  const auto findings = Look();
  const auto broken = Broken(findings);
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].subject, "laser 1");
  EXPECT_EQ(findings.back().subject, "laser 2");
  EXPECT_EQ(findings.back().health, Health::kFine);
}

TEST_F(DoctorTest, ACameraThatGoesIsAFinding) {
  Hook(device_)->frame = [](int call, Result<Frame> frame) -> Result<Frame> {
    if (call < 3) return frame;
    return DeviceError("the camera is gone; plug it in again");
  };
  const auto broken = Broken(Look());
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_NE(broken[0].sentence.find("gone"), std::string::npos);
}

TEST_F(DoctorTest, ACalibrationOfAnotherCameraIsAFinding) {
  ReadyCalibration ready = Ready();
  ready.calibration.device.camera.width = 1600;
  const auto broken = Broken(Look(&ready));
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].subject, "calibration");
}

TEST(Doctor, ADeviceThatDoesNotOpenAndAFolderThatIsMissingAreFindings) {
  DoctorRequest request;
  request.device = "/nowhere/device.toml";
  request.calibration_path = "/nowhere/calibration.json";
  request.data_dir = "/nowhere";
  const auto report = ExamineDevice(request, {});
  ASSERT_TRUE(report.ok());
  EXPECT_FALSE(report->healthy());
  EXPECT_EQ(Broken(report->findings).size(), 3U);
}

TEST(Doctor, WithoutADeviceTheMachineIsLookedAt) {
  const auto report = ExamineDevice({}, {});
  ASSERT_TRUE(report.ok());
  EXPECT_GE(report->findings.size(), 3U);
}

TEST(Doctor, AnInterruptIsAnError) {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const auto report = ExamineDevice({}, context);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
