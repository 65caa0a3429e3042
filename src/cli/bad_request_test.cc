// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "base/json.h"
#include "cli/bad_images_test.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// A sound capture with something wrong around it: calibration, options, place to write, names.
class BadRequestTest : public ProgramTest {};

TEST_F(BadRequestTest, ALaserThatTheCalibrationDoesNotKnow) {
  ExpectRefused(Reconstruct(ScanFixture::CalibrationJson(), {"--lasers", "5"}), 2, {"5"});
  ExpectNothingWritten();
}

TEST_F(BadRequestTest, ACalibrationFileThatIsNoGood) {
  const std::string whole = WholeFile(ScanFixture::CalibrationJson());
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    EXPECT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "c.json"},
      {"{}", "dorsum/calibration"},
      {"[]", "c.json"},
      {"null", "c.json"},
      {whole.substr(0, whole.size() / 2), "c.json"},
      {whole.substr(0, 300), "c.json"},
      {replaced("dorsum/calibration", "dorsum/report"), "dorsum/report"},
      {replaced("\"version\": 1", "\"version\": 99"), "version"},
      {replaced("\"width\": 560", "\"width\": NaN"), "c.json"},
      {replaced("\"width\": 560", "\"width\": 1e400"), "c.json"},
      {replaced("\"width\": 560", "\"width\": 560.5"), "width"},
      {replaced("\"width\": 560", "\"width\": -560"), "width"},
      {replaced("\"width\": 560", "\"width\": 561"), "561x420"},
      {replaced("\"camera_matrix\": [", "\"camera_matrix\": [0,"), "camera_matrix"},
      {replaced("\"lasers\": [", "\"lasers\": [3,"), "lasers"},
      {replaced("\"lasers\"", "\"masers\""), "lasers"},
      {replaced(R"("background_image_base64": ")", R"("background_image_base64": "!)"), "background"},
      {replaced(R"("background_image_base64": ")", R"("background_image_base64": "QUJD)"), "background"},
      {std::string(100000, '['), "c.json"},
  };
  const fs::path path = *this / "c.json";
  for (const auto& [text, culprit] : cases) {
    SCOPED_TRACE(text.substr(0, 60) + "… expecting " + culprit);
    PutFile(path, text);
    Capture();
    ExpectRefused(Reconstruct(path), 3, {culprit, "c.json"});
    ExpectNothingWritten();
  }
  ExpectRefused(Reconstruct(*this / "none.json"), 3, {"none.json"});
  ExpectRefused(Reconstruct(*this / "capture"), 3, {(*this / "capture").string()});
  ExpectNothingWritten();
}

TEST_F(BadRequestTest, NowhereToWrite) {
  PutFile(*this / "file", "mine");
  for (const char* out : {"file", "file/below", "file/below/deep"}) {
    const ProgramRun run = RunProgram({"reconstruct", ScanFixture::CaptureDir(ScanFixture::kBox), "-c",
                                       ScanFixture::CalibrationJson(), "-o", *this / out});
    ExpectRefused(run, 3, {(*this / out).string()});
  }
  EXPECT_EQ(Everything(*this / ""), (std::set<std::string>{"file", "out"}));
  EXPECT_EQ(WholeFile(*this / "file"), "mine");
}

TEST_F(BadRequestTest, AFolderThatMayNotBeWrittenTo) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may write anywhere";
  fs::permissions(*this / "out", fs::perms::owner_read | fs::perms::owner_exec);
  ExpectRefused(Reconstruct(), 3, {"out"});
  fs::permissions(*this / "out", fs::perms::owner_all);
  ExpectNothingWritten();
}

TEST_F(BadRequestTest, ASettingsFileThatIsNoGood) {
  const fs::path settings = *this / "settings.toml";
  for (const auto& [text, culprit] :
       std::vector<std::pair<std::string, std::string>>{{"[reconstruct", "settings.toml"},
                                                        {"reconstruct = 3", "reconstruct"},
                                                        {"[reconstruct]\npitch = 1.0", "pitch"},
                                                        {"[reconstruct]\npitch-mm = 100.0", "pitch-mm"},
                                                        {"[reconstruct]\npitch-mm = nan", "pitch-mm"},
                                                        {"[reconstruct]\npitch-mm = [1, 2]", "pitch-mm"},
                                                        {"[reconstruct]\nstripes = \"ridges\"", "ridges"}}) {
    PutFile(settings, text);
    ExpectRefused(Reconstruct(ScanFixture::CalibrationJson(), {"--settings", settings}), 3,
                  {"settings.toml", culprit});
    ExpectNothingWritten();
  }
}

TEST_F(BadRequestTest, OptionsThatLeaveNothingDoNotCrash) {
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--stripe-min-rows", "10000"},
                                             {"--stripe-min-area-px", "100000"},
                                             {"--stripe-offset", "255"},
                                             {"--mask-min-contrast", "255"},
                                             {"--stripe-block-px", "999"},
                                             {"--stripe-block-px", "60"},
                                             {"--stripe-median-px", "4"},
                                             {"--mask-open-px", "99"},
                                             {"--mask-open-px", "2"},
                                             {"--smooth-rows", "1000"},
                                             {"--max-gap-mm", "0.5", "--max-slope-deg", "10"},
                                             {"--pitch-mm", "0.1"},
                                             {"--pitch-mm", "5"}}) {
    SCOPED_TRACE(options[0] + " " + options[1]);
    std::vector<std::string> arguments = options;
    arguments.emplace_back("--no-report");
    const ProgramRun run = Reconstruct(ScanFixture::CalibrationJson(), arguments);
    if (run.code == 0) {
      EXPECT_TRUE(fs::exists(*this / "out" / "hand" / "points.ply"));
      fs::remove_all(*this / "out" / "hand");
    } else {
      ExpectRefused(run, run.code == 2 ? 2 : 3, {});
    }
    ExpectNothingWritten();
  }
}

// A report is opened in a browser: what people name their folders and boards must stay text.
TEST_F(BadRequestTest, AHostileNameStaysTextInTheReport) {
  const fs::path capture = *this / "<script>alert(1)<" / "<img src=x onerror=alert(2)>\"'&";
  fs::create_directories(capture.parent_path());
  ScanFixture::CopyFolder(ScanFixture::CaptureDir(ScanFixture::kBox), capture);
  fs::remove(capture / "stripesHand0.png");  // so that a warning names the folder too
  const fs::path out = *this / "out" / "hand";
  const ProgramRun run =
      RunProgram({"reconstruct", capture, "-c", ScanFixture::CalibrationJson(), "-o", out, "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string html = WholeFile(out / "report.html");
  EXPECT_NE(html.find("&lt;img src=x onerror=alert(2)&gt;"), std::string::npos);
  EXPECT_EQ(html.find("<img src=x"), std::string::npos);
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_TRUE(ReadJson(out / "report.json").ok());
  EXPECT_FALSE(Json::parse(run.out, nullptr, false).is_discarded());
}

// Linux names are bytes; JSON and HTML are UTF-8.
TEST_F(BadRequestTest, ANameThatIsNoUtf8IsNotOurFault) {
  const fs::path capture = *this / "caf\xe9 \xff";
  ScanFixture::CopyFolder(ScanFixture::CaptureDir(ScanFixture::kBox), capture);
  fs::remove(capture / "stripesHand0.png");
  const fs::path out = *this / "out" / "hand";
  const ProgramRun run =
      RunProgram({"reconstruct", capture, "-c", ScanFixture::CalibrationJson(), "-o", out, "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(ReadJson(out / "report.json").ok());
  EXPECT_FALSE(Json::parse(run.out, nullptr, false).is_discarded());
}

}  // namespace
}  // namespace dorsum
