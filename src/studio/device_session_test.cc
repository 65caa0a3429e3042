// SPDX-License-Identifier: Apache-2.0
#include "studio/device_session.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/virtual_bench.h"
#include "jobs/scan_fixture_test.h"
#include "studio/patience_test.h"

namespace dorsum {
namespace {

class DeviceSessionTest : public ::testing::Test {
 protected:
  void OpenSmall() {
    std::string text = ScanFixture::kDevice;
    text.insert(text.find("[camera]\n") + 9, "source = \"virtual:1\"\n");
    ASSERT_TRUE(WriteFile(dir_ / "device.toml", text).ok());
    QSignalSpy opened(&session_, &DeviceSession::Opened);
    session_.Open((dir_ / "device.toml").string());
    ASSERT_TRUE(opened.wait(kPatience_ms));
  }
  // What is lit, as the device's own thread sees it.
  ChannelSet Lit() {
    std::optional<ChannelSet> lit;
    session_.Run<ChannelSet>(
        "look", [](Device& device, const Context&) { return device.lights->On(); },
        [&](Result<ChannelSet> on) { lit = *on; });
    EXPECT_TRUE(QTest::qWaitFor([&] { return lit.has_value(); }, kPatience_ms));
    return lit.value_or(ChannelSet(99));
  }

  TempFolder dir_;
  DeviceSession session_;
};

TEST_F(DeviceSessionTest, AnOpenDeviceSaysWhatItIs) {
  OpenSmall();
  ASSERT_TRUE(session_.facts().has_value());
  EXPECT_TRUE(session_.facts()->is_virtual);
  EXPECT_EQ(session_.facts()->description.lasers.size(), 3U);
}

TEST_F(DeviceSessionTest, ADeviceThatIsNotThereIsSaidAndTheWindowGoesOn) {
  std::optional<Error> error;
  QObject::connect(&session_, &DeviceSession::Failed, [&](const Error& e) { error = e; });
  session_.Open("/nowhere/device.toml");
  ASSERT_TRUE(QTest::qWaitFor([&] { return error.has_value(); }, kPatience_ms));
  EXPECT_EQ(error->code, ErrorCode::kBadInput);
  EXPECT_FALSE(session_.facts().has_value());
  OpenSmall();
  EXPECT_TRUE(session_.facts().has_value());
}

TEST_F(DeviceSessionTest, ThePreviewShowsFramesAndStopsWithDarkLights) {
  OpenSmall();
  int frames = 0;
  QObject::connect(&session_, &DeviceSession::FrameReady,
                   [&](const cv::Mat& picture) { frames += picture.cols == 560 ? 1 : 0; });
  session_.StartPreview(LedChannels(session_.facts()->description), FrameLight::kLeds);
  ASSERT_TRUE(QTest::qWaitFor([&] { return frames >= 3; }, kPatience_ms));
  session_.StopPreview();
  EXPECT_TRUE(Lit().none());
}

TEST_F(DeviceSessionTest, TasksRunOneAfterTheOtherAndLeaveNoLightOn) {
  OpenSmall();
  std::vector<int> done;
  for (int i = 0; i < 3; ++i) {
    session_.Run<int>(
        "task",
        [i](Device& device, const Context&) -> Result<int> {
          DORSUM_RETURN_IF_ERROR(device.lights->Set(ChannelSet(1)));
          return i;
        },
        [&](Result<int> value) { done.push_back(*value); });
  }
  EXPECT_TRUE(session_.busy());
  EXPECT_TRUE(Lit().none());
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2}));
}

TEST_F(DeviceSessionTest, WithoutADeviceATaskFailsInASentence) {
  std::optional<Error> error;
  session_.Run<int>(
      "task", [](Device&, const Context&) -> Result<int> { return 1; },
      [&](const Result<int>& value) { error = value.error(); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return error.has_value(); }, kPatience_ms));
  EXPECT_EQ(error->code, ErrorCode::kDevice);
}

TEST_F(DeviceSessionTest, ATaskThatRunsCanBeCancelled) {
  OpenSmall();
  std::optional<Error> error;
  session_.Run<int>(
      "endless",
      [](Device&, const Context& context) -> Result<int> {
        while (!context.IsCancelled()) std::this_thread::yield();
        return Cancelled();
      },
      [&](const Result<int>& value) { error = value.error(); });
  QTest::qWait(20);
  session_.Cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return error.has_value(); }, kPatience_ms));
  EXPECT_EQ(error->code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
