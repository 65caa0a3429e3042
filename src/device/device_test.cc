// SPDX-License-Identifier: Apache-2.0
#include "device/device.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/take_picture.h"
#include "device/virtual_bench.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// The least description there can be: of 64 x 64 pixels, with this source and port.
fs::path WriteDevice(const TempFolder& dir, const std::string& source, const std::string& port = "") {
  const std::string text = "[camera]\nsource = \"" + source + "\"\nresolution_px = [64, 64]\n" +
                           "focal_length_px = 90.0\n[controller]\nport = \"" + port +
                           "\"\n[[laser]]\nposition_mm = [0.0, 0.0, 395.0]\n" +
                           "[[led]]\nposition_mm = [0.0, -520.0, 940.0]\n";
  fs::path path = dir / "device.toml";
  EXPECT_TRUE(WriteFile(path, text).ok());
  return path;
}

TEST(Device, VirtualIsTheBuiltInDeviceOfItsSeed) {
  const auto one = OpenDevice("virtual", {}), named = OpenDevice("virtual:1", {}),
             other = OpenDevice("virtual:eve", {});
  ASSERT_TRUE(one.ok() && named.ok() && other.ok());
  EXPECT_EQ(one->description.lasers.size(), 4U);
  EXPECT_EQ(one->bench->seed(), named->bench->seed());
  EXPECT_NE(one->bench->seed(), other->bench->seed());
}

TEST(Device, ADescriptionMayBeOfAVirtualDevice) {
  const TempFolder dir;
  const auto device = OpenDevice(WriteDevice(dir, "virtual:7").string(), {});
  ASSERT_TRUE(device.ok()) << device.error().message;
  ASSERT_TRUE(device->bench);
  EXPECT_EQ(device->frames->size(), cv::Size(64, 64));
}

TEST(Device, AMissingDescriptionIsBadInput) {
  for (const char* which : {"/nowhere/device.toml", "virtual:", "virtuel", ""}) {
    const auto device = OpenDevice(which, {});
    ASSERT_FALSE(device.ok()) << which;
    EXPECT_EQ(device.error().code, ErrorCode::kBadInput) << which;
  }
}

TEST(Device, AControllerThatIsNotThereIsADeviceError) {
  const TempFolder dir;
  const auto device = OpenDevice(WriteDevice(dir, "0", "/dev/ttyNOTHERE").string(), {});
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().code, ErrorCode::kDevice);
  EXPECT_NE(device.error().message.find("/dev/ttyNOTHERE"), std::string::npos) << device.error().message;
}

TEST(Device, ACaptureFolderIsShownAgainUnderItsLights) {
  const TempFolder dir;
  fs::create_directories(dir / "capture");
  const auto write = [&](const std::string& name, double value) {
    const cv::Mat picture(64, 64, CV_8UC3, cv::Scalar::all(value));
    ASSERT_TRUE(cv::imwrite((dir / "capture" / name).string(), picture));
  };
  write("bgHand.png", 150.0);
  write("stripesHand0.png", 60.0);
  auto device = OpenDevice(WriteDevice(dir, (dir / "capture").string()).string(), {});
  ASSERT_TRUE(device.ok()) << device.error().message;
  const auto mean = [&](const ChannelSet& on) {
    const auto picture = TakePicture(*device, on, FrameLight::kLeds, {}, {});
    EXPECT_TRUE(picture.ok()) << picture.error().message;
    return picture.ok() ? cv::mean(*picture)[1] : -1.0;
  };
  EXPECT_EQ(mean(LedChannels(device->description)), 150.0);
  EXPECT_EQ(mean(LaserChannel(device->description, 0)), 60.0);
  EXPECT_EQ(mean({}), 0.0);
  const auto both = LedChannels(device->description) | LaserChannel(device->description, 0);
  EXPECT_EQ(TakePicture(*device, both, FrameLight::kLeds, {}, {}).error().code, ErrorCode::kBadInput);
  fs::remove(dir / "capture" / "stripesHand0.png");
  EXPECT_FALSE(TakePicture(*device, LaserChannel(device->description, 0), FrameLight::kLaser, {}, {}).ok());
}

}  // namespace
}  // namespace dorsum
