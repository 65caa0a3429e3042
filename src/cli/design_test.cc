// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/json.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class DesignProgramTest : public ProgramTest {};

TEST_F(DesignProgramTest, TableJsonAndHelp) {
  const ProgramRun text = RunProgram({"design", "--resolution", "320,240", "--focal-length-px", "416"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("orders of laser 0"), std::string::npos);
  const ProgramRun json = RunProgram({"design", "--device", "devices/two-lasers-70.toml", "--json"});
  EXPECT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(Json::parse(json.out, nullptr, false)["lasers"].size(), 2U) << json.out;
  const ProgramRun help = RunProgram({"design", "--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_NE(help.out.find("Example: dorsum design"), std::string::npos);
}

TEST_F(DesignProgramTest, WrongUsageIsExitCodeTwo) {
  const std::vector<std::vector<std::string>> cases = {
      {"--lines-per-mm", "nan"}, {"--lines-per-mm", "0"}, {"--orders", "-1"},     {"--hand-mm", "10"},
      {"--resolution", "7,9"},   {"--surface", "glass"},  {"--albedo", "2"},      {"--heights", "nan,80"},
      {"--gratings", "nan"},     {"--baselines", "60"},   {"--baseline-mm", "x"}, {"--lasers", "9"}};
  for (const auto& words : cases) {
    std::vector<std::string> arguments = {"design", "-o", (*this / "out" / "mine").string()};
    arguments.insert(arguments.end(), words.begin(), words.end());
    ExpectRefused(RunProgram(arguments), 2, {words[0]});
  }
  EXPECT_TRUE(Everything(*this / "out").empty());
}

TEST_F(DesignProgramTest, BadInputAndNowhereToWriteAreExitCodeThree) {
  const std::string out = (*this / "out" / "mine").string(), device = (*this / "device.toml").string();
  ExpectRefused(RunProgram({"design", "--device", device, "-o", out}), 3, {"device.toml"});
  ASSERT_TRUE(WriteFile(device, "[grating]\nlines_per_mm = nan\n[[laser]]\n[[led]]\n").ok());
  ExpectRefused(RunProgram({"design", "--device", device, "-o", out}), 3, {"device.toml", "lines_per_mm"});
  ExpectRefused(RunProgram({"design", "--lines-per-mm", "3000", "-o", out}), 3, {"3000"});
  ExpectRefused(RunProgram({"design", "--slit-um", "11", "-o", out}), 3, {"slit"});
  ExpectRefused(RunProgram({"design", "--heights", "80,10", "-o", out}), 3, {"working_heights_mm"});
  ExpectRefused(RunProgram({"design", "-o", device + "/mine"}), 3, {"device.toml"});
  EXPECT_TRUE(Everything(*this / "out").empty());
}

TEST_F(DesignProgramTest, ASearchWithoutAnAnswerIsExitCodeOne) {
  ExpectRefused(RunProgram({"design", "--search", "--gratings", "1000"}), 1, {"1000 lines/mm"});
}

}  // namespace
}  // namespace dorsum
