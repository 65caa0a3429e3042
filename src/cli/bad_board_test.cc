// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "base/json.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class BadBoardTest : public ProgramTest {};

TEST_F(BadBoardTest, ItSaysWhatItWroteAsTextAndAsJson) {
  const std::string pdf = *this / "targets.pdf";
  const ProgramRun text = RunProgram({"board", "-o", pdf});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(text.out, pdf + "\n");
  EXPECT_EQ(text.err, "");
  const ProgramRun json =
      RunProgram({"board", "--sheets", "plan,chessboard", "-o", *this / "out" / "pdf", "--json"});
  EXPECT_EQ(json.code, 0) << json.err;
  const Json result = Json::parse(json.out, nullptr, false);
  ASSERT_EQ(result["files"].size(), 2U) << json.out;
  EXPECT_EQ(result["sheets"][0]["size_mm"], Json({210.0, 165.0}));
  EXPECT_EQ(Everything(*this / "out"), (std::set<std::string>{"pdf", "pdf/chessboard.pdf", "pdf/plan.pdf"}));
}

TEST_F(BadBoardTest, WrongUsageIsNamed) {
  const std::string out = *this / "out" / "targets.pdf";
  ExpectRefused(RunProgram({"board"}), 2, {"--out"});
  ExpectRefused(RunProgram({"board", "-o", out, "--paper", "A9"}), 2, {"A9", "Letter"});
  ExpectRefused(RunProgram({"board", "-o", out, "--paper", "nanxnan"}), 2, {"nanxnan"});
  ExpectRefused(RunProgram({"board", "-o", out, "--sheets", "moon"}), 2, {"moon"});
  ExpectNothingWritten();
}

TEST_F(BadBoardTest, DevicesPaperAndPlacesThatWillNotDo) {
  const std::string device = *this / "device.toml", out = *this / "out" / "targets.pdf";
  ExpectRefused(RunProgram({"board", "-o", out, "--device", *this / "none.toml"}), 3, {"none.toml"});
  ASSERT_TRUE(WriteFile(device, "[board]\nsquare_mm = 60\n[[laser]]\n[[led]]\n").ok());
  ExpectRefused(RunProgram({"board", "-o", out, "--device", device}), 3,
                {"840 x 660 mm", "--tile-chessboard"});
  ASSERT_TRUE(WriteFile(device, "[board]\nsquare_mm = nan\n[[laser]]\n[[led]]\n").ok());
  ExpectRefused(RunProgram({"board", "-o", out, "--device", device}), 3, {"square_mm"});
  ExpectRefused(RunProgram({"board", "-o", out, "--paper", "120x150"}), 3, {"chessboard", "fits on"});
  ExpectRefused(RunProgram({"board", "-o", *this / "none" / "targets.pdf"}), 3, {"none"});
  ExpectRefused(RunProgram({"board", "-o", "/dev/full/targets.pdf"}), 3, {"/dev/full"});
  ExpectRefused(RunProgram({"board", "-o", device}), 3, {"device.toml", "folder"});  // a file of that name
  ExpectNothingWritten();
  EXPECT_EQ(Everything(*this / "."), (std::set<std::string>{"device.toml", "out"}));
}

}  // namespace
}  // namespace dorsum
