// SPDX-License-Identifier: Apache-2.0
// `dorsum capture` on the real ways: the light controller's firmware in simavr on a pseudo-terminal, and a
// network camera that sees the lights which that firmware has on.
#include <array>
#include <csignal>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <sys/resource.h>

#include "cli/program_test.h"
#include "device/mjpeg_server_test.h"
#include "device/serial_relay_test.h"
#include "device/simulated_controller_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kLeds = 1U << 8;

class CaptureProgramTest : public ProgramTest {
 protected:
  void SetUp() override {
    if (!SimulatedController::Available()) GTEST_SKIP() << "needs avr-gcc and simavr: scripts/setup";
    controller_ = std::make_unique<SimulatedController>();
    const fs::path capture = ScanFixture::CaptureDir(ScanFixture::kBox);
    Learn(0, cv::Mat(420, 560, CV_8UC3, cv::Scalar::all(3)));
    Learn(kLeds, cv::imread((capture / "bgHand.png").string()));
    for (unsigned k = 0; k < 3; ++k) {
      Learn(1U << k, cv::imread((capture / ("stripesHand" + std::to_string(k) + ".png")).string()));
    }
    server_ = std::make_unique<MjpegServer>([this](int frame) { return Part(frame); });
  }

  // Some frames of a scene under these lights: what differs is the sensor's noise.
  void Learn(unsigned lit, const cv::Mat& picture) {
    cv::RNG rng(lit + 1);
    for (std::string& jpeg : frames_[lit]) {
      cv::Mat noise(picture.size(), CV_16SC3), noisy;
      rng.fill(noise, cv::RNG::NORMAL, 0.0, 1.0);
      cv::add(picture, noise, noisy, cv::noArray(), CV_8U);
      jpeg = JpegOf(noisy, 97);
    }
  }

  // What the camera does instead of showing the scene; the server's thread calls it, after the test's end
  // too.
  using Camera = std::function<std::optional<MjpegServer::Part>(int frame)>;
  void Use(Camera camera) {
    const std::lock_guard lock(camera_mutex_);
    camera_ = std::move(camera);
  }

  MjpegServer::Part Part(int frame) {
    Camera camera;
    {
      const std::lock_guard lock(camera_mutex_);
      camera = camera_;
    }
    if (camera) {
      if (const auto act = camera(frame)) return *act;
    }
    const auto seen = frames_.find(SimulatedController::LastLit(controller_->Log()));
    const auto& scene = seen == frames_.end() ? frames_[0] : seen->second;
    return scene.at(static_cast<std::size_t>(frame) % scene.size());
  }

  fs::path WriteDevice(const std::string& port) {
    std::string text = ScanFixture::kDevice;
    const std::string camera = "[camera]\n";
    text.insert(text.find(camera) + camera.size(), "source = \"" + server_->url() + "\"\n");
    text += "[controller]\nport = \"" + port + "\"\n";
    fs::path path = *this / "device.toml";
    EXPECT_TRUE(WriteFile(path, text).ok());
    return path;
  }
  std::vector<std::string> Arguments(const std::string& port) {
    return {"capture", *this / "out" / "box",         "--device", WriteDevice(port),
            "-c",      ScanFixture::CalibrationJson()};
  }
  // No light is on, and none will be: within the time that the firmware promises after its host's last word.
  void ExpectDark() { EXPECT_TRUE(controller_->WaitForLit(0)) << "lights are on"; }

  std::map<unsigned, std::array<std::string, 4>> frames_;  // JPEGs, by what is lit
  std::mutex camera_mutex_;
  Camera camera_;
  std::unique_ptr<SimulatedController> controller_;
  std::unique_ptr<MjpegServer> server_;
};

TEST_F(CaptureProgramTest, FirmwareAndNetworkCameraGiveAWholeCapture) {
  const ProgramRun run = RunProgram(Arguments(controller_->port()));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Everything(*this / "out" / "box").size(), 5U);
  // One light after the other, never two lasers together.
  EXPECT_EQ(controller_->LitSets(), (std::vector<unsigned>{kLeds, 1, 2, 4, kLeds}));
  ExpectDark();
  const ProgramRun surface =
      RunProgram({"reconstruct", *this / "out" / "box", "-c", ScanFixture::CalibrationJson(), "-o",
                  *this / "out" / "surface", "--no-report"});
  ASSERT_EQ(surface.code, 0) << surface.err;
  const ProgramRun plane =
      RunProgram({"evaluate", *this / "out" / "surface", "--plane-height", "25.5", "--json"});
  ASSERT_EQ(plane.code, 0) << plane.err;
  EXPECT_NE(plane.out.find("rmse"), std::string::npos);
}

TEST_F(CaptureProgramTest, ACameraThatFreezesHangsOrGoesIsSaidAndNothingStays) {
  for (const MjpegServer::Act act : {MjpegServer::Act::kHold, MjpegServer::Act::kClose}) {
    for (const unsigned lit : {kLeds, 2U}) {
      Use([this, act, lit](int) -> std::optional<MjpegServer::Part> {
        if (SimulatedController::LastLit(controller_->Log()) != lit) return std::nullopt;
        return MjpegServer::Part(act);
      });
      const ProgramRun run = RunProgram(Arguments(controller_->port()));
      ExpectRefused(run, 4, {"stream"});
      ExpectNothingWritten();
      ExpectDark();
    }
  }
}

TEST_F(CaptureProgramTest, ABlackCameraIsSaid) {
  Use([this](int frame) -> std::optional<MjpegServer::Part> {
    return MjpegServer::Part(frames_[0].at(static_cast<std::size_t>(frame) % 4));
  });
  ExpectRefused(RunProgram(Arguments(controller_->port())), 4, {"LEDs"});
  ExpectNothingWritten();
  ExpectDark();
}

TEST_F(CaptureProgramTest, ACameraOfAnotherSizeIsSaid) {
  const std::string small = JpegOf(cv::Mat(200, 300, CV_8UC3, cv::Scalar::all(90)));
  Use([small](int) -> std::optional<MjpegServer::Part> { return MjpegServer::Part(small); });
  ExpectRefused(RunProgram(Arguments(controller_->port())), 4, {"300", "560"});
  ExpectNothingWritten();
}

TEST_F(CaptureProgramTest, AControllerThatIsPulledOutIsSaid) {
  for (const unsigned lit : {kLeds, 1U, 4U}) {
    SerialRelay relay(controller_->port());
    const ProgramRun run = RunProgram(Arguments(relay.port()), [&](pid_t) {
      EXPECT_TRUE(controller_->WaitForLit(lit));
      relay.Cut();
    });
    ExpectRefused(run, 4, {"controller"});
    ExpectNothingWritten();
    ExpectDark();
  }
}

TEST_F(CaptureProgramTest, AControllerThatRestartsInTheMiddleGivesNoWrongPicture) {
  for (const unsigned lit : {kLeds, 2U}) {
    const ProgramRun run = RunProgram(Arguments(controller_->port()), [&](pid_t) {
      EXPECT_TRUE(controller_->WaitForLit(lit));
      controller_->Command("reset");
    });
    // Either the reset fell between two pictures and was made good, or it is said.
    if (run.code == 0) {
      fs::remove_all(*this / "out" / "box");
    } else {
      ExpectRefused(run, 4, {"controller"});
    }
    ExpectNothingWritten();
    ExpectDark();
  }
}

TEST_F(CaptureProgramTest, AnInterruptSwitchesEverythingOff) {
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const unsigned lit : {kLeds, 4U}) {
      const ProgramRun run = RunProgram(Arguments(controller_->port()), [&](pid_t pid) {
        EXPECT_TRUE(controller_->WaitForLit(lit));
        kill(pid, signal);
      });
      ExpectRefused(run, 130, {"interrupted"});
      ExpectNothingWritten();
      ExpectDark();
    }
  }
}

TEST_F(CaptureProgramTest, AHostThatIsKilledLeavesNoLightOnAndNoHalfCapture) {
  for (const unsigned lit : {kLeds, 1U}) {
    double killed_s = 0.0;
    const ProgramRun run = RunProgram(Arguments(controller_->port()), [&](pid_t pid) {
      EXPECT_TRUE(controller_->WaitForLit(lit));
      kill(pid, SIGKILL);
      killed_s = controller_->Now();
    });
    EXPECT_EQ(run.code, -1);
    ExpectDark();
    EXPECT_LT(controller_->LastChange(), killed_s + 2.1);
    EXPECT_FALSE(fs::exists(*this / "out" / "box"));
  }
}

TEST_F(CaptureProgramTest, AFullDiskIsSaidAndNothingStays) {
  if (access("/dev/full", W_OK) != 0) GTEST_SKIP() << "no /dev/full";
  std::vector<std::string> arguments = Arguments(controller_->port());
  // Half of a capture fits.
  const ProgramRun run = RunProgram(arguments, [](pid_t pid) {
    const rlimit half{200000, 200000};
    EXPECT_EQ(prlimit(pid, RLIMIT_FSIZE, &half, nullptr), 0);
  });
  ExpectRefused(run, 3, {"box"});
  ExpectNothingWritten();
  ExpectDark();
}

}  // namespace
}  // namespace dorsum
