// SPDX-License-Identifier: Apache-2.0
// OpenVideoFrames() on Motion JPEG over HTTP.
#include <atomic>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "device/mjpeg_server_test.h"
#include "device/still_picture.h"
#include "device/video_frames.h"
#include "device/video_pictures_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Act = MjpegServer::Act;

Result<std::unique_ptr<FrameSource>> OpenStream(const MjpegServer& server,
                                                VideoLimits limits = QuickLimits()) {
  return OpenVideoFrames(VideoKind::kStream, server.url(), VideoDesign(), limits, {});
}

TEST(StreamTest, FramesComeInOrderWithTheirArrivalAsTime) {
  MjpegServer server([](int i) { return JpegOf(GreyPicture(20 + i % 200, i)); }, 0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_TRUE((*stream)->ExposeFor(FrameLight::kLaser).ok());
  double before_s = 0.0;
  std::int64_t number = -1;
  double level = 0.0;
  for (int i = 0; i < 20; ++i) {
    const auto frame = (*stream)->Next(10.0);
    ASSERT_TRUE(frame.ok()) << frame.error().message;
    EXPECT_GT(frame->number, number);
    EXPECT_GT(LevelOf(frame->image), level) << "none twice and none older";
    EXPECT_GE(frame->time_s, before_s);
    EXPECT_LE(frame->time_s, MonotonicSeconds());
    number = frame->number;
    before_s = frame->time_s;
    level = LevelOf(frame->image) + 0.5;
  }
}

TEST(StreamTest, StillPictureOfAStreamWhoseLightChanges) {
  std::atomic<int> level = 40;
  MjpegServer server([&](int i) { return JpegOf(GreyPicture(level, i)); }, 0.01);
  auto stream = OpenStream(server, {5.0, 5.0});
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  StillOptions options;
  options.average = 4;
  options.timeout_s = 60.0;
  for (const int next : {120, 60, 200}) {
    level = next;
    const auto still = TakeStill(**stream, MonotonicSeconds(), options, {});
    ASSERT_TRUE(still.ok()) << still.error().message;
    EXPECT_NEAR(LevelOf(*still), next, 1.0);
    options.before = *still;
  }
}

TEST(StreamTest, ServerThatClosesInMidStreamIsNamed) {
  MjpegServer server(
      [](int i) { return i < 5 ? MjpegServer::Part(JpegOf(GreyPicture(80, i))) : Act::kClose; }, 0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  const Error error = ErrorAtTheEnd(**stream);
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  EXPECT_THAT(error.message, AllOf(HasSubstr(server.url()), HasSubstr("closed by the other side")));
}

TEST(StreamTest, StreamThatFallsSilentIsAnErrorThatStays) {
  MjpegServer server([](int i) { return i < 5 ? MjpegServer::Part(JpegOf(GreyPicture(80, i))) : Act::kHold; },
                     0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  for (int again = 0; again < 2; ++again) {
    const Error error = ErrorAtTheEnd(**stream);
    EXPECT_EQ(error.code, ErrorCode::kDevice);
    EXPECT_THAT(error.message, HasSubstr("stopped sending pictures: none came for 0.5 s"));
  }
}

TEST(StreamTest, LateFrameIsATimeOutAndThenTheFrame) {
  MjpegServer server([](int i) { return JpegOf(GreyPicture(80, i)); }, 0.4);
  auto stream = OpenStream(server, {10.0, 10.0});
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  bool late = false;
  for (int i = 0; i < 1000 && !late; ++i) {
    const auto frame = (*stream)->Next(0.001);
    late = !frame.ok();
    if (late) {
      EXPECT_THAT(frame.error().message, HasSubstr("sent no picture within 0.001 s"));
    }
  }
  EXPECT_TRUE(late);
  EXPECT_TRUE((*stream)->Next(10.0).ok());
}

TEST(StreamTest, DamagedPictureIsPassedOverAndLeavesAGap) {
  MjpegServer server(
      [](int i) {
        std::string jpeg = JpegOf(GreyPicture(20 + i % 200, i));
        if (i % 3 == 2) jpeg.replace(jpeg.size() / 2, 200, std::string(200, '\xff'));
        if (i % 7 == 3) jpeg.resize(jpeg.size() / 2);
        if (i % 11 == 4) jpeg = "no JPEG at all";
        return jpeg;
      },
      0.01);
  auto stream = OpenStream(server, {10.0, 10.0});
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  std::int64_t last = -1, gaps = 0;
  for (int i = 0; i < 20; ++i) {
    const auto frame = (*stream)->Next(10.0);
    ASSERT_TRUE(frame.ok()) << frame.error().message;
    cv::Scalar mean, deviation;
    cv::meanStdDev(frame->image, mean, deviation);
    EXPECT_LT(deviation[1], 4.0) << "half a picture";
    gaps += frame->number - last - 1;
    last = frame->number;
  }
  EXPECT_GT(gaps, 3);
}

TEST(StreamTest, NothingButDamagedPicturesIsAnError) {
  MjpegServer server(
      [](int i) {
        std::string jpeg = JpegOf(GreyPicture(80, i));
        if (i > 5) jpeg.replace(jpeg.size() / 2, 200, std::string(200, '\xff'));
        return jpeg;
      },
      0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_THAT(ErrorAtTheEnd(**stream).message, HasSubstr("damaged pictures only"));
}

TEST(StreamTest, PictureThatChangesItsSizeIsAnError) {
  MjpegServer server(
      [](int i) {
        return JpegOf(i < 5 ? GreyPicture(80, i) : cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(i)));
      },
      0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_THAT(ErrorAtTheEnd(**stream).message, AllOf(HasSubstr("160x120"), HasSubstr("320x240")));
}

TEST(StreamTest, BlackPicturesAreGivenAsTheyAre) {
  MjpegServer server([](int) { return JpegOf(cv::Mat(kVideoSize, CV_8UC3, cv::Scalar::all(0))); }, 0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  const auto frame = (*stream)->Next(10.0);
  ASSERT_TRUE(frame.ok());
  EXPECT_EQ(cv::countNonZero(frame->image.reshape(1)), 0);
}

TEST(StreamTest, ServerThatNeverAnswersIsAnErrorInTime) {
  MjpegServer server([](int) { return Act::kHold; }, 0.01, false);
  const auto stream = OpenStream(server, {0.5, 0.5});
  ASSERT_FALSE(stream.ok());
  EXPECT_EQ(stream.error().code, ErrorCode::kDevice);
  EXPECT_THAT(stream.error().message, HasSubstr("within 0.5 s"));
}

TEST(StreamTest, RefusedConnectionIsAnErrorAtOnce) {
  std::string url;
  {
    MjpegServer server([](int) { return Act::kHold; });
    url = server.url();
  }
  const auto stream = OpenVideoFrames(VideoKind::kStream, url, VideoDesign(), {30.0, 30.0}, {});
  ASSERT_FALSE(stream.ok());
  EXPECT_THAT(stream.error().message,
              AllOf(HasSubstr(url), HasSubstr("cannot be opened"), HasSubstr("address")));
}

TEST(StreamTest, DestructionWhileAReadHangsComesBack) {
  for (int i = 0; i < 2; ++i) {
    MjpegServer server(
        [](int f) { return f < 2 ? MjpegServer::Part(JpegOf(GreyPicture(80, f))) : Act::kHold; }, 0.01);
    auto stream = OpenStream(server, {2.0, 0.6});
    ASSERT_TRUE(stream.ok()) << stream.error().message;
    while ((*stream)->Next(0.1).ok()) continue;
    EXPECT_THAT((*stream)->Next(0.01).error().message, HasSubstr("sent no picture")) << "it hangs now";
  }
}

TEST(StreamTest, InterruptionWhileOpeningComesBack) {
  MjpegServer server([](int) { return Act::kHold; }, 0.01, false);
  std::atomic<bool> cancel = true;
  Context context;
  context.cancel = &cancel;
  const auto stream = OpenVideoFrames(VideoKind::kStream, server.url(), VideoDesign(), {0.5, 0.5}, context);
  ASSERT_FALSE(stream.ok());
  EXPECT_EQ(stream.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
