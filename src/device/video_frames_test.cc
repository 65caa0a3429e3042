// SPDX-License-Identifier: Apache-2.0
#include "device/video_frames.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/device_error.h"
#include "device/mjpeg_server_test.h"
#include "device/still_picture.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const cv::Size kSize(320, 240);
using Act = MjpegServer::Act;

// A grey picture of that level with noise, so that no two are equal.
cv::Mat Grey(int level, int seed = 0) {
  cv::Mat noise(kSize, CV_16SC3), image;
  cv::RNG rng(static_cast<std::uint64_t>(seed) + 17);
  rng.fill(noise, cv::RNG::NORMAL, 0.0, 2.0);
  cv::add(cv::Mat(kSize, CV_8UC3, cv::Scalar::all(level)), noise, image, cv::noArray(), CV_8U);
  return image;
}

double LevelOf(const cv::Mat& image) { return cv::mean(image)[1]; }

CameraDesign Design() {
  CameraDesign design;
  design.width = kSize.width;
  design.height = kSize.height;
  return design;
}

VideoLimits Quick() { return {2.0, 0.5}; }

Result<std::unique_ptr<FrameSource>> OpenStream(const MjpegServer& server, VideoLimits limits = Quick()) {
  return OpenVideoFrames(VideoKind::kStream, server.url(), Design(), limits, {});
}

// The error that ends a source, after whatever frames still come.
Error ErrorAtTheEnd(FrameSource& source) {
  for (int i = 0; i < 1000; ++i) {
    const auto frame = source.Next(10.0);
    if (!frame.ok()) return frame.error();
  }
  return {ErrorCode::kInternal, "(no end)"};
}

std::string WriteVideo(const std::filesystem::path& path, int frames) {
  cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 30.0,
                         kSize);
  for (int i = 0; i < frames; ++i) writer.write(Grey(10 + 10 * i, i));
  return path.string();
}

TEST(RecordingTest, EveryFrameComesOnceAndInOrderAndThenTheEnd) {
  const TempFolder dir;
  const std::string path = WriteVideo(dir / "hand.avi", 12);
  auto video = OpenVideoFrames(VideoKind::kRecording, path, Design(), Quick(), {});
  ASSERT_TRUE(video.ok()) << video.error().message;
  FrameSource& frames = **video;
  EXPECT_EQ(frames.size(), kSize);
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
  auto video = OpenVideoFrames(VideoKind::kRecording, path, Design(), Quick(), {});
  ASSERT_TRUE(video.ok()) << video.error().message;
  const Error error = ErrorAtTheEnd(**video);
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  EXPECT_THAT(error.message, HasSubstr("cut off"));
}

TEST(RecordingTest, MissingFileAndFileThatIsNoVideoAreErrors) {
  const TempFolder dir;
  ASSERT_TRUE(WriteFile(dir / "notes.avi", "This is not a video.").ok());
  for (const char* name : {"notes.avi", "nowhere.avi"}) {
    const auto video = OpenVideoFrames(VideoKind::kRecording, (dir / name).string(), Design(), Quick(), {});
    ASSERT_FALSE(video.ok());
    EXPECT_EQ(video.error().code, ErrorCode::kDevice);
    EXPECT_THAT(video.error().message, AllOf(HasSubstr(name), HasSubstr("no video")));
  }
}

TEST(RecordingTest, OtherSizeThanTheDescriptionSaysIsAnErrorAtOnce) {
  const TempFolder dir;
  CameraDesign design = Design();
  design.width = 640;
  const auto video =
      OpenVideoFrames(VideoKind::kRecording, WriteVideo(dir / "hand.avi", 3), design, Quick(), {});
  ASSERT_FALSE(video.ok());
  EXPECT_EQ(video.error().code, ErrorCode::kDevice);
  EXPECT_THAT(video.error().message,
              AllOf(HasSubstr("320x240"), HasSubstr("640x240"), HasSubstr("resolution_px")));
}

TEST(RecordingTest, FramesThatNobodyTakesDoNotKeepTheReaderRunning) {
  const TempFolder dir;
  const std::string path = WriteVideo(dir / "hand.avi", 12);
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(OpenVideoFrames(VideoKind::kRecording, path, Design(), Quick(), {}).ok());
}

TEST(StreamTest, FramesComeInOrderWithTheirArrivalAsTime) {
  MjpegServer server([](int i) { return JpegOf(Grey(20 + i % 200, i)); }, 0.01);
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
  MjpegServer server([&](int i) { return JpegOf(Grey(level, i)); }, 0.01);
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
  MjpegServer server([](int i) { return i < 5 ? MjpegServer::Part(JpegOf(Grey(80, i))) : Act::kClose; },
                     0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  const Error error = ErrorAtTheEnd(**stream);
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  EXPECT_THAT(error.message, AllOf(HasSubstr(server.url()), HasSubstr("closed by the other side")));
}

TEST(StreamTest, StreamThatFallsSilentIsAnErrorThatStays) {
  MjpegServer server([](int i) { return i < 5 ? MjpegServer::Part(JpegOf(Grey(80, i))) : Act::kHold; }, 0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  for (int again = 0; again < 2; ++again) {
    const Error error = ErrorAtTheEnd(**stream);
    EXPECT_EQ(error.code, ErrorCode::kDevice);
    EXPECT_THAT(error.message, HasSubstr("stopped sending pictures: none came for 0.5 s"));
  }
}

TEST(StreamTest, LateFrameIsATimeOutAndThenTheFrame) {
  MjpegServer server([](int i) { return JpegOf(Grey(80, i)); }, 0.4);
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
        std::string jpeg = JpegOf(Grey(20 + i % 200, i));
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
        std::string jpeg = JpegOf(Grey(80, i));
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
      [](int i) { return JpegOf(i < 5 ? Grey(80, i) : cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(i))); },
      0.01);
  auto stream = OpenStream(server);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_THAT(ErrorAtTheEnd(**stream).message, AllOf(HasSubstr("160x120"), HasSubstr("320x240")));
}

TEST(StreamTest, BlackPicturesAreGivenAsTheyAre) {
  MjpegServer server([](int) { return JpegOf(cv::Mat(kSize, CV_8UC3, cv::Scalar::all(0))); }, 0.01);
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
  const auto stream = OpenVideoFrames(VideoKind::kStream, url, Design(), {30.0, 30.0}, {});
  ASSERT_FALSE(stream.ok());
  EXPECT_THAT(stream.error().message,
              AllOf(HasSubstr(url), HasSubstr("cannot be opened"), HasSubstr("address")));
}

TEST(StreamTest, DestructionWhileAReadHangsComesBack) {
  for (int i = 0; i < 2; ++i) {
    MjpegServer server([](int f) { return f < 2 ? MjpegServer::Part(JpegOf(Grey(80, f))) : Act::kHold; },
                       0.01);
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
  const auto stream = OpenVideoFrames(VideoKind::kStream, server.url(), Design(), {0.5, 0.5}, context);
  ASSERT_FALSE(stream.ok());
  EXPECT_EQ(stream.error().code, ErrorCode::kCancelled);
}

// What stands between a test and the reading thread of a scripted input.
struct Gate {
  std::mutex mutex;
  std::condition_variable changed;
  bool open = true;
  bool hangs = false;  // a read stands before it
  bool gone = false;   // the input has been destroyed
  int reads = 0;
  std::vector<FrameLight> exposures;

  void Open() {
    const std::lock_guard lock(mutex);
    open = true;
    changed.notify_all();
  }
  void WaitUntilItHangs() {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return hangs; });
  }
  void WaitForReads(int count) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return reads >= count; });
  }
};

class ScriptedInput : public VideoInput {
 public:
  explicit ScriptedInput(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {}
  ~ScriptedInput() override {
    const std::lock_guard lock(gate_->mutex);
    gate_->gone = true;
    gate_->changed.notify_all();
  }
  Result<std::optional<Picture>> Read() override {
    std::unique_lock lock(gate_->mutex);
    if (gate_->reads > 5) {
      gate_->hangs = !gate_->open;
      gate_->changed.notify_all();
      gate_->changed.wait(lock, [&] { return gate_->open; });
    }
    ++gate_->reads;
    gate_->changed.notify_all();
    return std::optional(Picture{Grey(100, gate_->reads), 1000.0 - gate_->reads});  // a clock that runs back
  }
  std::vector<std::string> Begin() override { return {"the camera did not take the gain"}; }
  std::vector<std::string> Expose(FrameLight light) override {
    const std::lock_guard lock(gate_->mutex);
    gate_->exposures.push_back(light);
    return {"the camera did not take the exposure"};
  }
  bool CanBeSet() const override { return true; }
  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  const std::shared_ptr<Gate> gate_;
  const std::vector<std::string> warnings_ = {"the camera did not take the format"};
};

Result<std::unique_ptr<FrameSource>> OpenScripted(const std::shared_ptr<Gate>& gate, VideoLimits limits) {
  const auto opener = [gate]() -> Result<std::unique_ptr<VideoInput>> {
    return std::unique_ptr<VideoInput>(std::make_unique<ScriptedInput>(gate));
  };
  return OpenVideoFrames(VideoKind::kCamera, "the test's camera", opener, kSize, limits, {});
}

TEST(VideoFramesTest, NewestFramesAreKeptWhenNobodyTakesThem) {
  const auto gate = std::make_shared<Gate>();
  auto camera = OpenScripted(gate, {10.0, 10.0});
  ASSERT_TRUE(camera.ok()) << camera.error().message;
  gate->WaitForReads(50);
  const auto frame = (*camera)->Next(10.0);
  ASSERT_TRUE(frame.ok());
  EXPECT_GT(frame->number, 40);
}

TEST(VideoFramesTest, StampsNeverRunBackwards) {
  const auto gate = std::make_shared<Gate>();
  auto camera = OpenScripted(gate, {10.0, 10.0});
  ASSERT_TRUE(camera.ok());
  double before_s = 0.0;
  for (int i = 0; i < 10; ++i) {
    const auto frame = (*camera)->Next(10.0);
    ASSERT_TRUE(frame.ok());
    EXPECT_GE(frame->time_s, before_s);
    before_s = frame->time_s;
  }
}

TEST(VideoFramesTest, ExposureIsSetBetweenPicturesAndRefusalsAreSaidOnce) {
  const auto gate = std::make_shared<Gate>();
  auto camera = OpenScripted(gate, {10.0, 10.0});
  ASSERT_TRUE(camera.ok());
  ASSERT_TRUE((*camera)->ExposeFor(FrameLight::kLeds).ok());
  ASSERT_TRUE((*camera)->ExposeFor(FrameLight::kLaser).ok());
  {
    const std::lock_guard lock(gate->mutex);
    EXPECT_EQ(gate->exposures, (std::vector{FrameLight::kLeds, FrameLight::kLaser}));
  }
  EXPECT_THAT((*camera)->warnings(),
              ::testing::ElementsAre(HasSubstr("format"), HasSubstr("gain"), HasSubstr("exposure")));
}

TEST(VideoFramesTest, DriverThatNeverReturnsIsAbandonedAndEndsOnItsOwn) {
  const auto gate = std::make_shared<Gate>();
  gate->open = false;
  {
    auto camera = OpenScripted(gate, {0.2, 0.2});
    ASSERT_TRUE(camera.ok()) << camera.error().message;
    gate->WaitUntilItHangs();
    const Status exposure = (*camera)->ExposeFor(FrameLight::kLaser);
    ASSERT_FALSE(exposure.ok());
    EXPECT_EQ(exposure.error().code, ErrorCode::kDevice);
    EXPECT_THAT(exposure.error().message, HasSubstr("hangs"));
  }
  {
    const std::lock_guard lock(gate->mutex);
    EXPECT_FALSE(gate->gone) << "it still hangs, and nobody waits for it";
  }
  gate->Open();
  std::unique_lock lock(gate->mutex);
  gate->changed.wait(lock, [&] { return gate->gone; });
}

}  // namespace
}  // namespace dorsum
