// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cli/bad_images_test.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class BadCalibrationTest : public ProgramTest {
 protected:
  // Runs on the damaged series, whose message must hold `culprits`.
  void Refused(const std::string& what, const std::vector<std::string>& culprits) {
    SCOPED_TRACE(what);
    ExpectRefused(Calibrate(), 3, culprits);
    ExpectNothingWritten();
  }
  void Swap(const std::string& a, const std::string& b) {
    fs::rename(Series() / (a + ".png"), Series() / "aside");
    fs::rename(Series() / (b + ".png"), Series() / (a + ".png"));
    fs::rename(Series() / "aside", Series() / (b + ".png"));
  }
  void Overwrite(const std::string& image, const std::string& from) {
    fs::copy_file(ScanFixture::CalibrationDir() / (from + ".png"), Series() / (image + ".png"),
                  fs::copy_options::overwrite_existing);
  }
};

TEST_F(BadCalibrationTest, AnEmptyOrMissingFolder) {
  fs::create_directories(*this / "series");
  Refused("empty", {"setup.json"});
  ExpectRefused(RunProgram({"calibrate", *this / "none", "-o", *this / "out" / "c.json"}), 3,
                {(*this / "none").string()});
  ExpectNothingWritten();
}

TEST_F(BadCalibrationTest, EachMissingImageIsNamed) {
  for (const char* name :
       {"chess00", "laserCalFurtherBg", "laserCalCloserBg", "laser1CalFurther", "laser1CalCloser",
        "laser1CalFurtherChess", "laser1CalCloserChess", "laserFirstEstimates", "bgNoHand", "stripesBg1"}) {
    const std::string file = std::string(name) + ".png";
    fs::remove(Series() / file);
    Refused(name, {name, "missing", Series().string()});
    RestoreSeries(file);
  }
  for (const char* name : {"heights/h25.0/bgHand", "heights/h10.0/stripesHand1"}) {
    const std::string file = std::string(name) + ".png";
    fs::remove(Series() / file);
    const ProgramRun run = Calibrate();
    SCOPED_TRACE(name);
    if (run.code == 0) {  // as in any capture, the other lasers' images are still of use
      EXPECT_NE(run.err.find("stripesHand1"), std::string::npos) << "no warning: " << run.err;
      fs::remove_all(*this / "out");
      fs::create_directories(*this / "out");
    } else {
      ExpectRefused(run, 3, {fs::path(name).filename().string(), "h25.0"});
      ExpectNothingWritten();
    }
    RestoreSeries(file);
  }
}

// One of each way in which images are read: by the camera's, the lasers' and the backgrounds' calibration, by
// the boxes, by the report.
TEST_F(BadCalibrationTest, AnImageThatIsNoGoodIsNamed) {
  for (const std::string name :
       {"chess04", "laser1CalCloser", "laser2CalFurtherChess", "laserCalFurtherBg", "stripesBg0", "bgNoHand",
        "laserFirstEstimates", "heights/h25.0/stripesHand0"}) {
    for (const BadImage& bad : BadImages()) {
      if (bad.what == std::string("missing") || bad.what == std::string("a folder")) continue;  // see above
      // All kinds once; of the others those that show only when the image is decoded or used.
      const bool late =
          bad.what == std::string("truncated PNG") || bad.what == std::string("of another size");
      if (name != "chess04" && !late) continue;
      bad.spoil(Series(), name);
      Refused(name + " is " + bad.what, {name, bad.culprit});
      fs::remove(Series() / (name + ".jpg"));
      RestoreSeries(name + ".png");
    }
  }
}

TEST_F(BadCalibrationTest, BlackAndWhiteImages) {
  for (const std::string name :
       {"chess00", "laser1CalFurther", "stripesBg1", "laserFirstEstimates", "bgNoHand"}) {
    for (const int grey : {0, 255}) {
      PutImage(Series() / (name + ".png"), cv::Mat(420, 560, CV_8UC3, cv::Scalar::all(grey)));
      Refused(name + (grey == 0 ? " is black" : " is white"), {name});
    }
    RestoreSeries(name + ".png");
  }
}

TEST_F(BadCalibrationTest, OneViewWithoutAChessboardIsAWarning) {
  Overwrite("chess07", "bgNoHand");
  const ProgramRun run = Calibrate();
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err.rfind("dorsum: warning: ", 0), 0U) << run.err;
  EXPECT_NE(run.err.find("chess07"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("11.0000"), std::string::npos) << "views: " << run.out;
}

TEST_F(BadCalibrationTest, NineViewsWithoutAChessboardAreTooMany) {
  for (const char* name :
       {"chess01", "chess02", "chess03", "chess05", "chess06", "chess07", "chess08", "chess09", "chess11"}) {
    Overwrite(name, "bgNoHand");
  }
  Refused("three views left", {"3 of 12", "chessboard"});
}

TEST_F(BadCalibrationTest, TwelveTimesTheSameViewDoesNotDetermineTheCamera) {
  for (int view = 1; view < kChessViews; ++view) Overwrite(ChessName(view), "chess00");
  const ProgramRun run = Calibrate();
  EXPECT_NE(run.code, 0) << "the focal length is anybody's guess: " << run.out.substr(0, 400);
  if (run.code != 0) ExpectRefused(run, 3, {"chessboard"});
  ExpectNothingWritten();
}

TEST_F(BadCalibrationTest, TheFirstViewWithoutAChessboard) {
  Overwrite("chess00", "bgNoHand");
  Refused("nothing fixes the world", {"chess00"});
}

TEST_F(BadCalibrationTest, ASetupThatIsNoGood) {
  const fs::path path = Series() / "setup.json";
  const std::string whole = WholeFile(path);
  const auto with = [&](const std::string& key, const Json& value) {
    Json json = Json::parse(whole);
    json[Json::json_pointer(key)] = value;
    return json.dump();
  };
  std::string nan = whole;
  nan.replace(nan.find("532"), 3, "NaN");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "setup.json"},
      {whole.substr(0, whole.size() / 2), "setup.json"},
      {"[1, 2]", "setup.json"},
      {nan, "setup.json"},
      {with("/chessboard", 3), "chessboard"},
      {with("/chessboard/inner_corners", {9}), "inner_corners"},
      {with("/chessboard/inner_corners", {9.5, 6}), "inner_corners"},
      {with("/chessboard/inner_corners", {1000000, 1000000}), "inner_corners"},
      {with("/chessboard/inner_corners", {7, 7}), "chess00"},  // well-formed, but of another board
      {with("/chessboard/square_mm", -8), "square_mm"},
      {with("/calibration_object_height_mm", "50 mm"), "calibration_object_height_mm"},
      {with("/box_heights_mm", {10, nullptr}), "box_heights_mm"},
      {with("/wavelength_nm", 0), "wavelength_nm"},
      {with("/camera_resolution", {1600, 1200}), "1600x1200"},
      {with("/camera_resolution", {420, 560}), "420x560"},
  };
  for (const auto& [text, culprit] : cases) {
    PutFile(path, text);
    Refused(text, {culprit});
  }
  fs::remove(path);
  Refused("no setup.json", {"setup.json"});
}

TEST_F(BadCalibrationTest, CloserAndFurtherImagesSwapped) {
  for (int k = 0; k < 3; ++k) {
    const std::string laser = "laser" + std::to_string(k) + "Cal";
    Swap(laser + "Closer", laser + "Further");
    Swap(laser + "CloserChess", laser + "FurtherChess");
  }
  Swap("laserCalCloserBg", "laserCalFurtherBg");
  Refused("both kinds", {"swapped"});
}

TEST_F(BadCalibrationTest, CloserAndFurtherBoardsOfOneLaserSwapped) {
  Swap("laser1CalCloserChess", "laser1CalFurtherChess");
  Refused("the boards alone", {"laser 1", "swapped"});
}

// Pictures of the wrong kind under a name: no crash, no folder half-written, one sentence if refused.
TEST_F(BadCalibrationTest, PicturesOfSomethingElse) {
  for (const auto& [image, from] :
       std::vector<std::pair<std::string, std::string>>{{"laser1CalFurther", "chess03"},
                                                        {"laser0CalCloser", "laserCalCloserBg"},
                                                        {"laserCalFurtherBg", "laser0CalFurther"},
                                                        {"laser2CalCloserChess", "laser2CalCloser"},
                                                        {"stripesBg1", "stripesBg0"},
                                                        {"laserFirstEstimates", "bgNoHand"},
                                                        {"bgNoHand", "heights/h25.0/bgHand"},
                                                        {"heights/h25.0/bgHand", "bgNoHand"},
                                                        {"chess00", "laser1CalCloserChess"}}) {
    Overwrite(image, from);
    const ProgramRun run = Calibrate();
    SCOPED_TRACE(::testing::Message() << image << " is " << from);
    if (run.code == 0) {
      EXPECT_EQ(Everything(*this / "out"), (std::set<std::string>{"calibration.json", "calibration.html"}));
      fs::remove_all(*this / "out");
      fs::create_directories(*this / "out");
    } else {
      ExpectRefused(run, 3, {});
    }
    ExpectNothingWritten();
    RestoreSeries(image + ".png");
  }
}

TEST_F(BadCalibrationTest, NowhereToWrite) {
  PutFile(*this / "file", "mine");
  for (const char* out : {"file/c.json", "none/c.json", "out", "c.html"}) {
    ExpectRefused(RunProgram({"calibrate", ScanFixture::CalibrationDir(), "-o", *this / out}), 3,
                  {(*this / out).string()});
  }
  EXPECT_EQ(Everything(*this / ""), (std::set<std::string>{"file", "out"}));
}

}  // namespace
}  // namespace dorsum
