// SPDX-License-Identifier: Apache-2.0
#include "captures/device_description.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kLaser = "[[laser]]\n";
constexpr const char* kLed = "[[led]]\n";

class DeviceDescriptionTest : public ::testing::Test {
 protected:
  DeviceDescriptionTest() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    dir_ = std::filesystem::path(::testing::TempDir()) / (std::string("device_description_") + info->name());
    std::filesystem::create_directories(dir_);
  }
  ~DeviceDescriptionTest() override { std::filesystem::remove_all(dir_); }

  Result<DeviceDescription> Read(const std::string& text) {
    EXPECT_TRUE(WriteFile(dir_ / "device.toml", text).ok());
    return ReadDeviceDescription(dir_ / "device.toml");
  }

  std::string MessageOf(const std::string& text) {
    const auto result = Read(text);
    if (result.ok()) return "(no error)";
    EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(result.error().message, HasSubstr("device.toml"));
    EXPECT_EQ(result.error().message.find('\n'), std::string::npos) << "one sentence, one line";
    return result.error().message;
  }

  std::filesystem::path dir_;
};

TEST_F(DeviceDescriptionTest, ShippedDefaultFileSaysWhatIsBuiltIn) {
  const auto file = ReadDeviceDescription("devices/four-lasers.toml");
  ASSERT_TRUE(file.ok()) << file.error().message;
  const DeviceDescription built_in = DefaultDevice();
  EXPECT_EQ(file->name, built_in.name);
  EXPECT_EQ(file->camera.distortion, built_in.camera.distortion);
  EXPECT_EQ(file->camera.position_mm, built_in.camera.position_mm);
  EXPECT_EQ(file->camera.focal_length_px, built_in.camera.focal_length_px);
  EXPECT_EQ(file->camera.format, built_in.camera.format);
  EXPECT_EQ(file->sensor.full_well_e, built_in.sensor.full_well_e);
  EXPECT_EQ(file->box_heights_mm, built_in.box_heights_mm);
  EXPECT_EQ(file->light.laser_irradiance, built_in.light.laser_irradiance);
  EXPECT_EQ(file->skin.scatter_sigma_mm, built_in.skin.scatter_sigma_mm);
  EXPECT_EQ(file->mounting.principal_point_px, built_in.mounting.principal_point_px);
  ASSERT_EQ(file->lasers.size(), built_in.lasers.size());
  for (std::size_t k = 0; k < built_in.lasers.size(); ++k) {
    EXPECT_LT((file->lasers[k].position_mm - built_in.lasers[k].position_mm).norm(), 1e-9) << k;
    EXPECT_EQ(file->lasers[k].relative_power, built_in.lasers[k].relative_power) << k;
    EXPECT_EQ(file->lasers[k].channel, built_in.lasers[k].channel) << k;
  }
  ASSERT_EQ(file->leds.size(), built_in.leds.size());
  for (std::size_t l = 0; l < built_in.leds.size(); ++l) {
    EXPECT_EQ(file->leds[l].position_mm, built_in.leds[l].position_mm) << l;
  }
}

TEST_F(DeviceDescriptionTest, OtherShippedFileIsReadable) {
  const auto file = ReadDeviceDescription("devices/two-lasers-70.toml");
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ(file->lasers.size(), 2U);
  EXPECT_EQ(file->lasers[1].channel, 1);
  EXPECT_NEAR(file->grating.Step(), 532e-6 * 70.0 * std::sqrt(0.5), 1e-12);
}

TEST_F(DeviceDescriptionTest, DevicesOfTheAccuracyBenchDifferWhereTheySaySo) {
  const std::string folder = "bench/accuracy/devices/";
  const auto usual = ReadDeviceDescription(folder + "default.toml");
  const auto other = ReadDeviceDescription(folder + "other-design.toml");
  const auto bad = ReadDeviceDescription(folder + "bad.toml");
  ASSERT_TRUE(usual.ok() && other.ok() && bad.ok());
  EXPECT_FALSE(usual->sensor.bayer);
  EXPECT_TRUE(other->sensor.bayer);
  EXPECT_LT(usual->camera.position_mm.x() * other->camera.position_mm.x(), 0.0) << "on the other side";
  EXPECT_NE(other->lasers[0].tilt_deg, 0.0);
  EXPECT_EQ(bad->speckle.contrast, 2.0 * usual->speckle.contrast);
  EXPECT_EQ(bad->sensor.full_well_e, 0.25 * usual->sensor.full_well_e);
  EXPECT_EQ(bad->lasers.size(), usual->lasers.size());
}

TEST_F(DeviceDescriptionTest, MissingFileIsNamed) {
  const auto result = ReadDeviceDescription(dir_ / "nowhere.toml");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(result.error().message, HasSubstr("nowhere.toml"));
}

TEST_F(DeviceDescriptionTest, BrokenTomlNamesItsLine) {
  EXPECT_THAT(MessageOf("name = \"a\"\n[camera\n"), HasSubstr("line 2"));
}

TEST_F(DeviceDescriptionTest, UnknownKeyIsAnErrorThatListsTheKnownOnes) {
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[camera]\nfocal_lenght_px = 2000\n"),
              AllOf(HasSubstr("camera.focal_lenght_px"), HasSubstr("focal_length_px,")));
  EXPECT_THAT(MessageOf("lazer = 1\n" + std::string(kLaser) + kLed), HasSubstr("unknown key lazer"));
  EXPECT_THAT(MessageOf("[[laser]]\npower = 2\n" + std::string(kLed)), HasSubstr("laser[0].power"));
}

TEST_F(DeviceDescriptionTest, ValueOutOfRangeNamesValueAndRange) {
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[camera]\nfocal_length_px = 7\n"),
              AllOf(HasSubstr("camera.focal_length_px is 7"), HasSubstr("from 50 to 100000")));
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[camera]\nposition_mm = [0.0, 0.0, 20.0]\n"),
              AllOf(HasSubstr("camera.position_mm"), HasSubstr("20"), HasSubstr("from 100 to 3000")));
  EXPECT_THAT(MessageOf("[[laser]]\n[[laser]]\nhalf_angle_deg = 95.0\n" + std::string(kLed)),
              HasSubstr("laser[1].half_angle_deg"));
}

TEST_F(DeviceDescriptionTest, NotANumberIsRefused) {
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[sensor]\ngamma = nan\n"),
              HasSubstr("sensor.gamma is nan"));
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[camera]\nlook_at_mm = [0.0, 0.0, nan]\n"),
              HasSubstr("camera.look_at_mm"));
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[board]\nsquare_mm = inf\n"),
              HasSubstr("board.square_mm"));
}

TEST_F(DeviceDescriptionTest, WrongTypesAreRefused) {
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[camera]\nformat = \"tiff\"\n"),
              AllOf(HasSubstr("camera.format"), HasSubstr("jpeg"), HasSubstr("png")));
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[grating]\norders = 9.5\n"), HasSubstr("whole number"));
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[camera]\ndistortion = [0.1, 0.2]\n"),
              HasSubstr("a list of 5 numbers"));
  EXPECT_THAT(MessageOf("camera = 3\n" + std::string(kLaser) + kLed), HasSubstr("[camera] table"));
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[sensor]\nbayer = 1\n"),
              AllOf(HasSubstr("sensor.bayer"), HasSubstr("true or false")));
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[camera]\nstream_jpeg_quality = 10\n"),
              AllOf(HasSubstr("camera.stream_jpeg_quality"), HasSubstr("0 (none) or from 30 to 100")));
  EXPECT_THAT(MessageOf("name = 4\n" + std::string(kLaser) + kLed), HasSubstr("text in quotes"));
}

TEST_F(DeviceDescriptionTest, CameraSettingsAreReadAndLeftAsTheyAreByDefault) {
  const std::string lights = std::string(kLaser) + kLed + "[camera]\n";
  const auto bare = Read(lights);
  const auto shipped = ReadDeviceDescription("devices/four-lasers.toml");
  ASSERT_TRUE(bare.ok() && shipped.ok());
  for (const CameraDesign& camera : {bare->camera, shipped->camera}) {
    EXPECT_EQ(camera.stream_format, "mjpeg");
    EXPECT_EQ(camera.laser_exposure_s, 0.0);
    EXPECT_EQ(camera.led_exposure_s, 0.0);
    EXPECT_EQ(camera.gain, -1);
    EXPECT_EQ(camera.focus, -1);
    EXPECT_EQ(camera.white_balance_k, 0);
  }
  const auto set = Read(lights +
                        "source = \"/dev/video2\"\nstream_format = \"raw\"\nlaser_exposure_s = 0.004\n"
                        "led_exposure_s = 0.02\ngain = 0\nfocus = 30\nwhite_balance_k = 4600\n");
  ASSERT_TRUE(set.ok()) << set.error().message;
  EXPECT_EQ(set->camera.source, "/dev/video2");
  EXPECT_EQ(set->camera.stream_format, "raw");
  EXPECT_EQ(set->camera.laser_exposure_s, 0.004);
  EXPECT_EQ(set->camera.led_exposure_s, 0.02);
  EXPECT_EQ(set->camera.gain, 0);
  EXPECT_EQ(set->camera.focus, 30);
  EXPECT_EQ(set->camera.white_balance_k, 4600);
}

TEST_F(DeviceDescriptionTest, CameraSettingsOutOfRangeAreRefused) {
  const std::string lights = std::string(kLaser) + kLed + "[camera]\n";
  EXPECT_THAT(MessageOf(lights + "stream_format = \"h264\"\n"),
              AllOf(HasSubstr("camera.stream_format"), HasSubstr("mjpeg"), HasSubstr("raw")));
  EXPECT_THAT(MessageOf(lights + "laser_exposure_s = 0.00001\nled_exposure_s = 0.01\n"),
              AllOf(HasSubstr("camera.laser_exposure_s"), HasSubstr("from 0.0001 to 10")));
  EXPECT_THAT(MessageOf(lights + "laser_exposure_s = 0.01\n"),
              AllOf(HasSubstr("camera.led_exposure_s"), HasSubstr("given when the other exposure is")));
  EXPECT_THAT(MessageOf(lights + "led_exposure_s = 0.01\n"), HasSubstr("camera.laser_exposure_s"));
  EXPECT_THAT(MessageOf(lights + "gain = -2\n"), HasSubstr("camera.gain"));
  EXPECT_THAT(MessageOf(lights + "white_balance_k = 46\n"),
              AllOf(HasSubstr("camera.white_balance_k"), HasSubstr("from 1000 to 20000")));
}

TEST_F(DeviceDescriptionTest, NumberOfLasersIsOneToEight) {
  EXPECT_THAT(MessageOf(kLed), AllOf(HasSubstr("laser"), HasSubstr("1 to 8")));
  EXPECT_THAT(MessageOf("laser = []\n" + std::string(kLed)), HasSubstr("1 to 8"));
  std::string text = kLed;
  for (int k = 0; k < 8; ++k) text += kLaser;
  EXPECT_TRUE(Read(text).ok());
  EXPECT_THAT(MessageOf(text + kLaser), AllOf(HasSubstr("list of 9"), HasSubstr("1 to 8")));
}

TEST_F(DeviceDescriptionTest, OrdersThatCannotLeaveTheGratingAreRefused) {
  // The document's 1000 lines/mm: the third order already points beyond the horizon (DESIGN §2).
  EXPECT_THAT(MessageOf(std::string(kLaser) + kLed + "[grating]\nlines_per_mm = 1000\n"),
              AllOf(HasSubstr("grating.orders"), HasSubstr("at most 0.95")));
}

}  // namespace
}  // namespace dorsum
