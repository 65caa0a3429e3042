// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/json.h"
#include "base/version.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kCommands = {"simulate", "board",       "calibrate", "capture", "doctor",
                                            "campaign", "reconstruct", "evaluate",  "design"};

// A folder that no other program writes: the demo leaves its own, `out`, where the tests run.
const std::string kNowhere = "never-written-by-a-wrong-usage";

// Wrong usage: exit code 2, one sentence that names the culprit, and nothing read or written.
void ExpectUsageError(const std::vector<std::string>& arguments, const std::string& culprit) {
  SCOPED_TRACE(culprit);
  ExpectRefused(RunProgram(arguments), 2, {culprit});
}

TEST(UsageTest, EveryCommandsHelpHasAnExample) {
  for (const std::string& command : kCommands) {
    const ProgramRun run = RunProgram({command, "--help"});
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_EQ(run.err, "") << command;
    EXPECT_NE(run.out.find("Example: dorsum " + command), std::string::npos) << command;
    for (const char* option : {"--json", "--threads", "--quiet"}) {
      EXPECT_NE(run.out.find(option), std::string::npos) << command << " " << option;
    }
  }
  const ProgramRun all = RunProgram({"--help"});
  EXPECT_EQ(all.code, 0);
  for (const std::string& command : kCommands) EXPECT_NE(all.out.find(command), std::string::npos) << command;
}

TEST(UsageTest, VersionIsOneLineOnTheStandardOutput) {
  const ProgramRun run = RunProgram({"--version"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, std::string(kVersion) + "\n");
  EXPECT_EQ(run.err, "");
}

TEST(UsageTest, UnknownCommandsAndOptionsAreNamed) {
  ExpectUsageError({}, "command");
  ExpectUsageError({"frobnicate"}, "frobnicate");
  ExpectUsageError({"frobnicate", "in", "-o", "out"}, "frobnicate");
  ExpectUsageError({"calibrate", "in", "-o", "out.json", "--frobnicate"}, "--frobnicate");
  ExpectUsageError({"calibrate", "-o", "out.json"}, "calibration_dir");
  ExpectUsageError({"calibrate", "-o", "out.json"}, "see dorsum calibrate --help");
  ExpectUsageError({"reconstruct", "in", "-o", "out"}, "--calibration");
  ExpectUsageError({"evaluate", "one", "two", "--plane-height", "3"}, "two");
}

TEST(UsageTest, ValuesThatAnOptionDoesNotTakeAreNamed) {
  const auto with = [](const std::string& option, const std::string& value) {
    return std::vector<std::string>{"reconstruct", "in", "-c", "c.json", "-o", kNowhere, option, value};
  };
  ExpectUsageError(with("--sheets", "sphere"), "sphere");
  ExpectUsageError(with("--method", "guess"), "guess");
  ExpectUsageError(with("--stripes", "edges"), "edges");
  ExpectUsageError(with("--mesh", "ply,dwg"), "dwg");
  ExpectUsageError(with("--lasers", "9"), "--lasers");
  ExpectUsageError(with("--lasers", "one"), "--lasers");
  ExpectUsageError(with("--pitch-mm", "nan"), "--pitch-mm");
  ExpectUsageError(with("--pitch-mm", "0"), "--pitch-mm");
  ExpectUsageError(with("--threads", "-1"), "--threads");
  ExpectUsageError({"calibrate", "in", "-o", "c.json", "--method", "guess"}, "guess");
  ExpectUsageError({"evaluate", "out", "--fit", "cube"}, "cube");
  ExpectUsageError({"evaluate", "out", "--plane-height", "nan"}, "--plane-height");
  ExpectUsageError({"evaluate", "out", "--plane-height", "3", "--shrink-px", "-1"}, "--shrink-px");
  ExpectUsageError({"simulate", "-o", kNowhere, "--population", "-3"}, "--population");
  EXPECT_FALSE(fs::exists(kNowhere));
}

TEST(UsageTest, EvaluateTakesOneReferenceOnly) {
  ExpectUsageError({"evaluate", "out"}, "--plane-height");
  ExpectUsageError({"evaluate", "out", "--plane-height", "3", "--fit", "sphere"}, "--fit");
  ExpectUsageError({"evaluate", "out", "--fit", "sphere", "--against", "a.ply"}, "--against");
  ExpectUsageError({"evaluate", "out", "--against", "a.ply", "--plane-height", "3"}, "--against");
}

class SimulateProgramTest : public ProgramTest {};

TEST_F(SimulateProgramTest, UnknownScenesAreNamed) {
  const std::string out = *this / "out" / "scan";
  for (const char* scene : {"cube", "box", "boxnan", "box-5", "sphere1e9", "hand:dog:left:rex", "../../etc",
                            "hand:man:left:../x", "plane_r", ""}) {
    const ProgramRun run = RunProgram({"simulate", "-o", out, "--scene", scene, "--no-calibration"});
    EXPECT_EQ(run.code, 2) << scene << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(scene), std::string::npos) << run.err;
  }
  ExpectNothingWritten();
}

// A device file of which one line is broken says which one.
TEST_F(SimulateProgramTest, ABrokenDeviceFileIsNamedWithItsKey) {
  const std::string device = *this / "device.toml", out = *this / "out" / "scan";
  const std::string lights = "\n[[laser]]\n[[led]]\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[camera\n" + lights, "device.toml"},
      {"[camera]\nfocal_length_px = nan" + lights, "focal_length_px"},
      {"[camera]\nfocal_length_px = \"long\"" + lights, "focal_length_px"},
      {"[camera]\nresolution_px = [99999, 99999]" + lights, "resolution_px"},
      {"[camera]\nresolution_px = [640]" + lights, "resolution_px"},
      {"[camera]\nzoom = 3" + lights, "zoom"},
      {"[grating]\norders = 500" + lights, "orders"},
      {"[[led]]", "laser"},
      {"[[laser]]", "led"},
      {"[board]\nsquare_mm = -1" + lights, "square_mm"},
      {std::string("\0\xff\xfe", 3), "device.toml"},
      {"", "laser"},
  };
  for (const auto& [text, culprit] : cases) {
    ASSERT_TRUE(WriteFile(device, text).ok());
    ExpectRefused(RunProgram({"simulate", "-o", out, "--device", device, "--scene", "plane"}), 3, {culprit});
    ExpectNothingWritten();
  }
  ExpectRefused(RunProgram({"simulate", "-o", out, "--device", *this / "none.toml"}), 3, {"none.toml"});
  ExpectNothingWritten();
}

TEST_F(SimulateProgramTest, JsonOnTheStandardOutputOfEachCommand) {
  const std::string device = *this / "device.toml", scan = *this / "scan";
  std::string tiny = ScanFixture::kDevice;
  tiny.replace(tiny.find("[560, 420]"), 10, "[160, 120]");
  tiny.replace(tiny.find("728.0"), 5, "208.0");
  ASSERT_TRUE(WriteFile(device, tiny).ok());
  const ProgramRun simulate = RunProgram(
      {"simulate", "-o", scan, "--device", device, "--scene", "plane", "--no-calibration", "--json"});
  EXPECT_EQ(simulate.code, 0) << simulate.err;
  EXPECT_EQ(Json::parse(simulate.out, nullptr, false)["captures"], Json({"plane"})) << simulate.out;

  const ProgramRun calibrate =
      RunProgram({"calibrate", ScanFixture::CalibrationDir(), "-o", *this / "c.json", "--json"});
  EXPECT_EQ(calibrate.code, 0) << calibrate.err;
  EXPECT_EQ(Json::parse(calibrate.out, nullptr, false)["files"].size(), 2U);

  const std::string out = *this / "out" / "box";
  const ProgramRun reconstruct = RunProgram({"reconstruct", ScanFixture::CaptureDir(ScanFixture::kBox), "-c",
                                             *this / "c.json", "-o", out, "--no-report", "--json"});
  EXPECT_EQ(reconstruct.code, 0) << reconstruct.err;
  EXPECT_GT(Json::parse(reconstruct.out, nullptr, false)["points"], 1000);

  const ProgramRun evaluate = RunProgram({"evaluate", out, "--plane-height", "25.5", "--json"});
  EXPECT_EQ(evaluate.code, 0) << evaluate.err;
  EXPECT_EQ(Json::parse(evaluate.out, nullptr, false)["schema"], "dorsum/evaluation");
}

TEST_F(SimulateProgramTest, AFolderInUseIsNotOverwritten) {
  ASSERT_TRUE(WriteFile(*this / "out" / "notes.txt", "mine").ok());
  const ProgramRun run = RunProgram({"simulate", "-o", (*this / "out").string(), "--scene", "plane"});
  ExpectRefused(run, 3, {(*this / "out").string()});
  EXPECT_EQ(Everything(*this / "out"), (std::set<std::string>{"notes.txt"}));
}

}  // namespace
}  // namespace dorsum
