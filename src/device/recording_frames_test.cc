// SPDX-License-Identifier: Apache-2.0
// OpenVideoFrames() on video files.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/video_frames.h"
#include "device/video_pictures_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string WriteVideo(const std::filesystem::path& path, int frames) {
  cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 30.0,
                         kVideoSize);
  for (int i = 0; i < frames; ++i) writer.write(GreyPicture(10 + 10 * i, i));
  return path.string();
}

TEST(RecordingTest, EveryFrameComesOnceAndInOrderAndThenTheEnd) {
  const TempFolder dir;
  const std::string path = WriteVideo(dir / "hand.avi", 12);
  auto video = OpenVideoFrames(VideoKind::kRecording, path, VideoDesign(), QuickLimits(), {});
  ASSERT_TRUE(video.ok()) << video.error().message;
  FrameSource& frames = **video;
  EXPECT_EQ(frames.size(), kVideoSize);
  EXPECT_THAT(frames.name(), HasSubstr("hand.avi"));
  double before_s = 0.0;
  for (int i = 0; i < 12; ++i) {
    const auto frame = frames.Next(10.0);
    ASSERT_TRUE(frame.ok()) << frame.error().message;
    EXPECT_EQ(frame->number, i);
    EXPECT_NEAR(LevelOf(frame->image), 10 + 10 * i, 2.0);
    EXPECT_EQ(frame->image.type(), CV_8UC3);
    EXPECT_GE(frame->time_s, before_s);
    before_s = frame->time_s;
  }
  for (int again = 0; again < 2; ++again) {
    const auto end = frames.Next(10.0);
    ASSERT_FALSE(end.ok());
    EXPECT_EQ(end.error().code, ErrorCode::kDevice);
    EXPECT_THAT(end.error().message, AllOf(HasSubstr("has ended after 12 frames"), HasSubstr("hand.avi")));
  }
}

TEST(RecordingTest, CutOffRecordingSaysHowMuchThereWas) {
  const TempFolder dir;
  const std::string path = WriteVideo(dir / "hand.avi", 12);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) * 6 / 10);
  auto video = OpenVideoFrames(VideoKind::kRecording, path, VideoDesign(), QuickLimits(), {});
  ASSERT_TRUE(video.ok()) << video.error().message;
  const Error error = ErrorAtTheEnd(**video);
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  EXPECT_THAT(error.message, HasSubstr("cut off"));
}

TEST(RecordingTest, MissingFileAndFileThatIsNoVideoAreErrors) {
  const TempFolder dir;
  ASSERT_TRUE(WriteFile(dir / "notes.avi", "This is not a video.").ok());
  for (const char* name : {"notes.avi", "nowhere.avi"}) {
    const auto video =
        OpenVideoFrames(VideoKind::kRecording, (dir / name).string(), VideoDesign(), QuickLimits(), {});
    ASSERT_FALSE(video.ok());
    EXPECT_EQ(video.error().code, ErrorCode::kDevice);
    EXPECT_THAT(video.error().message, AllOf(HasSubstr(name), HasSubstr("no video")));
  }
}

TEST(RecordingTest, OtherSizeThanTheDescriptionSaysIsAnErrorAtOnce) {
  const TempFolder dir;
  CameraDesign design = VideoDesign();
  design.width = 640;
  const auto video =
      OpenVideoFrames(VideoKind::kRecording, WriteVideo(dir / "hand.avi", 3), design, QuickLimits(), {});
  ASSERT_FALSE(video.ok());
  EXPECT_EQ(video.error().code, ErrorCode::kDevice);
  EXPECT_THAT(video.error().message,
              AllOf(HasSubstr("320x240"), HasSubstr("640x240"), HasSubstr("resolution_px")));
}

TEST(RecordingTest, FramesThatNobodyTakesDoNotKeepTheReaderRunning) {
  const TempFolder dir;
  const std::string path = WriteVideo(dir / "hand.avi", 12);
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(OpenVideoFrames(VideoKind::kRecording, path, VideoDesign(), QuickLimits(), {}).ok());
}

}  // namespace
}  // namespace dorsum
