// SPDX-License-Identifier: Apache-2.0
#include "device/video_frames.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/video_pictures_test.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

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
    return std::optional(
        Picture{GreyPicture(100, gate_->reads), 1000.0 - gate_->reads});  // a clock that runs back
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
  return OpenVideoFrames(VideoKind::kCamera, "the test's camera", opener, kVideoSize, limits, {});
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
