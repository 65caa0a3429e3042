// SPDX-License-Identifier: Apache-2.0
// A capture with the very firmware (in simavr) while one byte on the serial line is lost, doubled or garbled,
// each way, in each step of the session.
#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "captures/capture.h"
#include "device/serial_lights.h"
#include "device/serial_relay_test.h"
#include "device/simulated_controller_test.h"
#include "jobs/capture.h"
#include "jobs/virtual_device_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kLeds = 1U << 8;

// Sees the fixture's box under whatever the firmware has lit at this moment, with other noise each time.
class PinFrames : public FrameSource {
 public:
  explicit PinFrames(SimulatedController* controller) : controller_(controller) {
    const fs::path capture = ScanFixture::CaptureDir(ScanFixture::kBox);
    pictures_[kLeds] = cv::imread((capture / "bgHand.png").string());
    for (unsigned k = 0; k < 3; ++k) {
      pictures_[1U << k] = cv::imread((capture / ("stripesHand" + std::to_string(k) + ".png")).string());
    }
    pictures_[0] = cv::Mat(pictures_[kLeds].size(), CV_8UC3, cv::Scalar::all(3));
  }
  Result<Frame> Next(double /*timeout_s*/) override {
    const double now_s = MonotonicSeconds();
    const unsigned lit = SimulatedController::LastLit(controller_->Log());
    const auto seen = pictures_.find(lit);
    cv::Mat picture = (seen == pictures_.end() ? pictures_[0] : seen->second).clone();
    picture.at<cv::Vec3b>(0, 0)[0] = static_cast<std::uint8_t>(number_ % 200);
    return Frame{picture, now_s, number_++};
  }
  Status ExposeFor(FrameLight /*light*/) override { return {}; }
  cv::Size size() const override { return {560, 420}; }
  std::string name() const override { return "the test's camera"; }
  std::vector<std::string> warnings() const override { return {}; }
  bool stamps_exposure() const override { return true; }

  const cv::Mat& Of(unsigned lit) { return pictures_[lit]; }

 private:
  SimulatedController* controller_;
  std::map<unsigned, cv::Mat> pictures_;
  std::int64_t number_ = 0;
};

struct Harm {
  Way way;
  Mischief mischief;
};

class CaptureSerialTest : public ::testing::TestWithParam<Harm> {
 protected:
  void SetUp() override {
    if (!SimulatedController::Available()) GTEST_SKIP() << "needs avr-gcc and simavr: scripts/setup";
  }
  static Result<Device> Open(SimulatedController* controller, const std::string& port,
                             const TempFolder& dir) {
    Device device = OpenFixtureDevice(dir);
    device.bench.reset();
    device.frames = std::make_unique<PinFrames>(controller);
    SerialLightsOptions options;
    options.port = port;
    options.link.answer_s = 0.09;
    options.link.tries = 20;  // a busy machine may be late; together below the silence limit
    DORSUM_ASSIGN_OR_RETURN(device.lights, OpenSerialLights(options, {}));
    return device;
  }
  // Each picture was taken under its own light and no other.
  static void ExpectRightPictures(const fs::path& dir, PinFrames& frames) {
    const auto same = [&](const std::string& name, unsigned lit) {
      const cv::Mat picture = cv::imread((dir / (name + ".png")).string());
      ASSERT_EQ(picture.size(), frames.size()) << name;
      EXPECT_EQ(cv::norm(picture.rowRange(1, 420), frames.Of(lit).rowRange(1, 420), cv::NORM_INF), 0.0)
          << name;
    };
    same("bgHand", kLeds);
    for (unsigned k = 0; k < 3; ++k) same("stripesHand" + std::to_string(k), 1U << k);
    same("bgHandAfter", kLeds);
  }
};

TEST_P(CaptureSerialTest, NoByteMakesAWrongPictureOrLeavesALightOn) {
  const TempFolder dir;
  SimulatedController controller;
  SerialRelay relay(controller.port());
  int whole = 0;
  for (int step = 0; step < 6; ++step) {
    SCOPED_TRACE(step);
    auto device = Open(&controller, relay.port(), dir);
    ASSERT_TRUE(device.ok()) << device.error().message;
    auto& frames = dynamic_cast<PinFrames&>(*device->frames);
    CaptureRequest request;
    request.out_dir = dir / "capture";
    Context context;
    int pictures = 0;
    context.progress = [&](std::string_view, double) {  // told before each picture
      if (pictures++ == step) relay.Arm(GetParam().way, GetParam().mischief, 7 + 5 * step);
    };
    const auto result = CaptureToFolder(*device, request, context);
    EXPECT_TRUE(relay.Done());
    if (result.ok()) {
      ++whole;
      ExpectRightPictures(request.out_dir, frames);
      fs::remove_all(request.out_dir);
    } else {
      EXPECT_EQ(result.error().code, ErrorCode::kDevice) << result.error().message;
      EXPECT_FALSE(fs::exists(request.out_dir));
    }
    EXPECT_TRUE(controller.WaitForLit(0));
  }
  EXPECT_GE(whole, 3) << "most harm of one byte should be made good";
}

std::string HarmName(const ::testing::TestParamInfo<Harm>& harm) {
  const char* names[] = {"Lost", "Doubled", "Garbled"};
  return std::string(harm.param.way == Way::kToHost ? "ToHost" : "ToController") +
         names[static_cast<int>(harm.param.mischief)];
}
INSTANTIATE_TEST_SUITE_P(
    EachWay, CaptureSerialTest,
    ::testing::Values(Harm{Way::kToController, Mischief::kLose}, Harm{Way::kToController, Mischief::kDouble},
                      Harm{Way::kToController, Mischief::kGarble}, Harm{Way::kToHost, Mischief::kLose},
                      Harm{Way::kToHost, Mischief::kDouble}, Harm{Way::kToHost, Mischief::kGarble}),
    HarmName);

}  // namespace
}  // namespace dorsum
