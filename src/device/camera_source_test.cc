// SPDX-License-Identifier: Apache-2.0
#include "device/camera_source.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/camera_list.h"
#include "device/folder_frames.h"
#include "device/mjpeg_server_test.h"
#include "device/still_picture.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const cv::Size kSize(96, 64);

void WriteImage(const std::filesystem::path& path, int level) {
  ASSERT_TRUE(cv::imwrite(path.string(), cv::Mat(kSize, CV_8UC3, cv::Scalar::all(level))));
}

CameraDesign DesignOf(const std::string& source) {
  CameraDesign design;
  design.source = source;
  design.width = kSize.width;
  design.height = kSize.height;
  return design;
}

TEST(CameraSourceTest, EachKindIsKnown) {
  const TempFolder dir;
  ASSERT_TRUE(WriteFile(dir / "a.avi", "x").ok());
  const std::vector<std::pair<std::string, CameraKind>> sources = {
      {"", CameraKind::kFirst},
      {"0", CameraKind::kNumber},
      {"12", CameraKind::kNumber},
      {"/dev/video3", CameraKind::kNumber},
      {"http://10.0.0.7:8080/video", CameraKind::kStream},
      {"rtsp://camera/1", CameraKind::kStream},
      {dir.path().string(), CameraKind::kFolder},
      {(dir / "a.avi").string(), CameraKind::kRecording},
      {"virtual", CameraKind::kVirtual},
      {"virtual:7", CameraKind::kVirtual},
  };
  for (const auto& [text, kind] : sources) {
    const auto source = ParseCameraSource(text);
    ASSERT_TRUE(source.ok()) << text;
    EXPECT_EQ(source->kind, kind) << text;
  }
  EXPECT_EQ(ParseCameraSource("12")->place, "/dev/video12");
  EXPECT_EQ(ParseCameraSource("virtual:7")->place, "7");
}

TEST(CameraSourceTest, TextThatIsNoneIsAnErrorOfInput) {
  for (const char* text : {"webcam", "99999999999999999999", "-1", "nowhere/hand.avi", "virtua", "1.5"}) {
    const auto source = ParseCameraSource(text);
    ASSERT_FALSE(source.ok()) << text;
    EXPECT_EQ(source.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(source.error().message, AllOf(HasSubstr(text), HasSubstr("/dev/videoN")));
  }
}

TEST(CameraSourceTest, CameraThatIsNotThereIsADeviceError) {
  const auto camera = OpenCamera(DesignOf("/dev/video987"), {});
  ASSERT_FALSE(camera.ok());
  EXPECT_EQ(camera.error().code, ErrorCode::kDevice);
  EXPECT_THAT(camera.error().message, AllOf(HasSubstr("/dev/video987"), HasSubstr("cannot be opened")));
  EXPECT_THROW((void)OpenCamera(DesignOf("virtual"), {}), std::logic_error);
}

TEST(CameraSourceTest, FileThatIsNoCameraIsADeviceError) {
  const auto camera = OpenCamera(DesignOf("/dev/null"), {});
  ASSERT_FALSE(camera.ok());
  EXPECT_EQ(camera.error().code, ErrorCode::kDevice);
  EXPECT_THAT(camera.error().message, HasSubstr("cannot be opened as a camera"));
}

TEST(CameraSourceTest, StreamAndFolderAreOpenedThroughTheDescription) {
  MjpegServer server([](int i) { return JpegOf(cv::Mat(kSize, CV_8UC3, cv::Scalar::all(50 + i % 100))); },
                     0.01);
  const auto stream = OpenCamera(DesignOf(server.url()), {});
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_TRUE((*stream)->Next(10.0).ok());
  const TempFolder dir;
  WriteImage(dir / "a.png", 10);
  const auto folder = OpenCamera(DesignOf(dir.path().string()), {});
  ASSERT_TRUE(folder.ok()) << folder.error().message;
  EXPECT_TRUE((*folder)->Next(1.0).ok());
}

TEST(FolderFramesTest, ImagesComeInTheOrderOfTheirNamesAndThenTheEnd) {
  const TempFolder dir;
  WriteImage(dir / "b.png", 20);
  WriteImage(dir / "a.png", 10);
  WriteImage(dir / "c.png", 30);
  ASSERT_TRUE(WriteFile(dir / "notes.txt", "no image").ok());
  auto frames = FolderFrames::Open(dir.path(), {});
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  EXPECT_EQ((*frames)->size(), kSize);
  for (int i = 0; i < 3; ++i) {
    const auto frame = (*frames)->Next(1.0);
    ASSERT_TRUE(frame.ok());
    EXPECT_EQ(frame->number, i);
    EXPECT_EQ(frame->image.at<cv::Vec3b>(0, 0)[0], 10 * (i + 1));
  }
  const auto end = (*frames)->Next(1.0);
  ASSERT_FALSE(end.ok());
  EXPECT_EQ(end.error().code, ErrorCode::kDevice);
  EXPECT_THAT(end.error().message, AllOf(HasSubstr("no more images"), HasSubstr("c.png")));
}

TEST(FolderFramesTest, BadFilesAreNamed) {
  const TempFolder dir;
  EXPECT_EQ(FolderFrames::Open(dir.path(), kSize).error().code, ErrorCode::kBadInput);
  EXPECT_EQ(FolderFrames::Open(dir / "nowhere", kSize).error().code, ErrorCode::kBadInput);
  ASSERT_TRUE(WriteFile(dir / "a.png", "not a PNG").ok());
  WriteImage(dir / "b.png", 10);
  auto frames = FolderFrames::Open(dir.path(), {200, 100});
  ASSERT_TRUE(frames.ok());
  const auto broken = (*frames)->Next(1.0);
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().code, ErrorCode::kDevice);
  EXPECT_THAT(broken.error().message, HasSubstr("a.png"));
  EXPECT_THAT((*frames)->Next(1.0).error().message,
              AllOf(HasSubstr("b.png"), HasSubstr("96x64"), HasSubstr("200x100")));
}

TEST(FolderFramesTest, CaptureFolderIsReplayedByTheNamesOfItsPictures) {
  const TempFolder dir;
  WriteImage(dir / "bgHand.png", 120);
  WriteImage(dir / "stripesHand0.png", 30);
  auto frames = FolderFrames::Open(dir.path(), kSize);
  ASSERT_TRUE(frames.ok());
  for (const auto& [name, level] : {std::pair{"bgHand", 120}, {"stripesHand0", 30}, {"bgHand", 120}}) {
    ASSERT_TRUE((*frames)->Show(name).ok());
    const auto still = TakeStill(**frames, MonotonicSeconds(), {}, {});
    ASSERT_TRUE(still.ok()) << still.error().message;
    EXPECT_EQ(still->at<cv::Vec3b>(5, 5)[1], level);
  }
  EXPECT_EQ((*frames)->Show("stripesHand1").error().code, ErrorCode::kBadInput);
}

TEST(CameraListTest, NodesAreListedInTheOrderOfTheirNumbersWithTheirNames) {
  const TempFolder dir;
  std::filesystem::create_directories(dir / "dev");
  for (const char* node : {"video10", "video2", "video", "videoX", "video0", "vbi0"}) {
    ASSERT_TRUE(WriteFile(dir / "dev" / node, "").ok());
  }
  std::filesystem::create_symlink("nowhere", dir / "dev" / "video3");
  std::filesystem::create_directories(dir / "sys" / "video2");
  ASSERT_TRUE(WriteFile(dir / "sys" / "video2" / "name", "HD Webcam C525\n").ok());
  const auto cameras = ListCameras(dir / "dev", dir / "sys");
  ASSERT_EQ(cameras.size(), 4U);
  EXPECT_THAT(cameras[0].device, ::testing::EndsWith("video0"));
  EXPECT_THAT(cameras[1].device, ::testing::EndsWith("video2"));
  EXPECT_THAT(cameras[2].device, ::testing::EndsWith("video3"));
  EXPECT_THAT(cameras[3].device, ::testing::EndsWith("video10"));
  EXPECT_EQ(cameras[0].name, "");
  EXPECT_EQ(cameras[1].name, "HD Webcam C525");
  for (const CameraEntry& camera : cameras) EXPECT_FALSE(camera.usable);
  EXPECT_THAT(cameras[1].problem, HasSubstr("does not answer as a camera"));
  EXPECT_THAT(cameras[2].problem, HasSubstr("cannot be opened"));
  EXPECT_TRUE(ListCameras(dir / "nowhere", dir / "sys").empty());
}

}  // namespace
}  // namespace dorsum
