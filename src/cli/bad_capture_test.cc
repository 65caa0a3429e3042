// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cli/bad_images_test.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class BadCaptureTest : public ProgramTest {
 protected:
  // Runs on a damaged capture, whose message must hold `culprits`, and leaves the next case a whole one.
  void Refused(const std::string& what, const std::vector<std::string>& culprits) {
    SCOPED_TRACE(what);
    ExpectRefused(Reconstruct(), 3, culprits);
    ExpectNothingWritten();
    fs::remove_all(*this / "capture");
  }
};

TEST_F(BadCaptureTest, AnImageThatIsNoGoodIsNamed) {
  for (const char* name : {"bgHand", "stripesHand1"}) {
    for (const BadImage& bad : BadImages()) {
      const bool absent = bad.what == std::string("missing") || bad.what == std::string("a folder");
      if (absent && name != std::string("bgHand")) continue;  // a warning, as the next test has it
      bad.spoil(Capture(), name);
      const bool names_other = bad.what == std::string("of another size") && name == std::string("bgHand");
      Refused(std::string(name) + " is " + bad.what, {names_other ? "stripesHand0" : name, bad.culprit});
    }
  }
}

TEST_F(BadCaptureTest, AMissingStripeImageIsAWarning) {
  fs::remove(Capture() / "stripesHand1.png");
  const ProgramRun run = Reconstruct(ScanFixture::CalibrationJson(), {"--no-report"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err.rfind("dorsum: warning: ", 0), 0U) << run.err;
  EXPECT_NE(run.err.find("stripesHand1"), std::string::npos) << run.err;
  EXPECT_TRUE(fs::exists(*this / "out" / "hand" / "points.ply"));
  EXPECT_EQ(Reconstruct(ScanFixture::CalibrationJson(), {"--no-report", "--quiet"}).err, "");
}

TEST_F(BadCaptureTest, AFolderWithoutImages) {
  fs::create_directories(*this / "capture");
  Refused("empty", {"bgHand", "capture"});
  Capture();
  for (int k = 0; k < 3; ++k) fs::remove(*this / "capture" / ("stripesHand" + std::to_string(k) + ".png"));
  Refused("no stripes", {"stripesHand0"});
  const ProgramRun run = RunProgram(
      {"reconstruct", *this / "none", "-c", ScanFixture::CalibrationJson(), "-o", *this / "out" / "hand"});
  ExpectRefused(run, 3, {(*this / "none").string()});
  ExpectNothingWritten();
}

TEST_F(BadCaptureTest, BlackAndWhiteImages) {
  for (const char* name : {"bgHand", "stripesHand2"}) {
    for (const int grey : {0, 255}) {
      const cv::Mat image(420, 560, CV_8UC3, cv::Scalar::all(grey));
      PutImage(Capture() / (std::string(name) + ".png"), image);
      Refused(name, {name, grey == 0 ? "black" : "white"});
    }
  }
}

TEST_F(BadCaptureTest, NoHandInThePicture) {
  fs::copy_file(ScanFixture::CalibrationDir() / "bgNoHand.png", Capture() / "bgHand.png",
                fs::copy_options::overwrite_existing);
  for (const char* laser : {"0", "1", "2"}) {
    fs::copy_file(ScanFixture::CalibrationDir() / (std::string("stripesBg") + laser + ".png"),
                  Capture() / (std::string("stripesHand") + laser + ".png"),
                  fs::copy_options::overwrite_existing);
  }
  Refused("an empty backplane", {"no hand"});
}

TEST_F(BadCaptureTest, ALampThatMovedSinceTheCalibration) {
  cv::Mat image = GetImage(Capture() / "bgHand.png");
  image *= 0.2;
  PutImage(*this / "capture" / "bgHand.png", image);
  Refused("darker", {"bgHand"});
}

// The pictures of a chessboard instead of a hand's, and a picture of stripes instead of bgHand: whatever is
// made of them, no crash and no half-written folder.
TEST_F(BadCaptureTest, PicturesOfSomethingElse) {
  const auto tries = [&](const char* image, const char* from) {
    fs::copy_file(ScanFixture::CalibrationDir() / (std::string(from) + ".png"),
                  Capture() / (std::string(image) + ".png"), fs::copy_options::overwrite_existing);
    const ProgramRun run = Reconstruct(ScanFixture::CalibrationJson(), {"--no-report"});
    SCOPED_TRACE(std::string(image) + " is " + from);
    if (run.code == 0) {
      EXPECT_TRUE(fs::exists(*this / "out" / "hand" / "report.json"));
      fs::remove_all(*this / "out" / "hand");
    } else {
      ExpectRefused(run, 3, {});
    }
    ExpectNothingWritten();
    fs::remove_all(*this / "capture");
  };
  tries("bgHand", "chess00");
  tries("bgHand", "chess05");
  tries("bgHand", "stripesBg1");
  tries("bgHand", "laserCalCloserBg");
  tries("stripesHand0", "chess03");
  tries("stripesHand1", "laser0CalFurther");
  tries("stripesHand2", "laserCalFurtherBg");
}

TEST_F(BadCaptureTest, ACaptureOfAnotherCamera) {
  for (const auto& entry : fs::directory_iterator(Capture())) {
    cv::Mat image = GetImage(entry.path());
    cv::resize(image, image, {400, 300});
    PutImage(entry.path(), image);
  }
  Refused("all 400x300", {"560x420", "400x300"});
}

}  // namespace
}  // namespace dorsum
