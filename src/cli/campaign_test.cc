// SPDX-License-Identifier: Apache-2.0
#include <csignal>

#include <opencv2/imgcodecs.hpp>

#include "base/json.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class CampaignProgramTest : public ProgramTest {
 protected:
  static ProgramRun Run(std::vector<std::string> words,
                        const std::function<void(pid_t)>& meanwhile = nullptr) {
    words.insert(words.begin(), "campaign");
    return RunProgram(words, meanwhile);
  }
  void Begin() {
    ASSERT_EQ(Run({"new", Study(), "--sessions", "2", "--captures", "20"}).code, 0);
    ASSERT_EQ(Person("p01").code, 0);
  }
  ProgramRun Person(const std::string& id) {
    return Run({"add", Study(), "--id", id, "--sex", "woman", "--age-group", "20-29", "--consent-date",
                "2024-05-31"});
  }
  // A capture that is like no other.
  std::string Source(int seed) {
    const fs::path folder = *this / ("source" + std::to_string(seed));
    fs::create_directories(folder);
    cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
    for (const char* name : {"bgHand.png", "stripesHand0.png", "stripesHand1.png"}) {
      cv::Mat picture(240, 320, CV_8UC3);
      random.fill(picture, cv::RNG::UNIFORM, 0, 256);
      cv::imwrite((folder / name).string(), picture);
    }
    return folder;
  }
  std::vector<std::string> Import(int seed, const std::string& hand = "left") {
    return {"add", Study(), "--id", "p01", "--hand", hand, "--from", Source(seed)};
  }
  std::string Study() { return *this / "out" / "study"; }
  int Captures() { return Json::parse(Run({"status", Study(), "--json"}).out, nullptr, false)["captures"]; }
};

TEST_F(CampaignProgramTest, AWholeCampaignFromTheCommandLine) {
  Begin();
  const ProgramRun added = Run(Import(1));
  EXPECT_EQ(added.code, 0) << added.err;
  EXPECT_NE(added.out.find("people/p01/sessions/1/left/1\n"), std::string::npos) << added.out;
  EXPECT_NE(added.err.find("no calibration yet"), std::string::npos) << added.err;
  const Json status = Json::parse(Run({"status", Study(), "--json"}).out, nullptr, false);
  EXPECT_EQ(status["sexes"]["woman"], 1);
  EXPECT_EQ(status["captures"], 1);
  EXPECT_EQ(Run({"verify", Study()}).code, 0);
  EXPECT_EQ(Run({"export", Study(), "-o", *this / "out" / "export"}).code, 0);
  EXPECT_TRUE(fs::exists(*this / "out" / "export" / "export.json"));
  const ProgramRun batch = RunProgram({"reconstruct", Study(), "-o", *this / "out" / "surfaces", "--batch"});
  ExpectRefused(batch, 3, {"without a calibration", "--calibration"});

  std::ofstream(fs::path(Study()) / "people/p01/sessions/1/left/1/bgHand.png", std::ios::app) << "x";
  const ProgramRun changed = Run({"verify", Study()});
  EXPECT_EQ(changed.code, 1);
  EXPECT_NE(changed.out.find("bgHand.png has "), std::string::npos) << changed.out;
  EXPECT_EQ(Json::parse(Run({"verify", Study(), "--json"}).out, nullptr, false)["findings"].size(), 1U);
  const ProgramRun removed = Run({"remove", Study(), "--id", "p01"});
  EXPECT_EQ(removed.code, 0) << removed.err;
  EXPECT_EQ(Run({"verify", Study()}).code, 0);
  for (const std::string& name : Everything(Study())) EXPECT_EQ(name.find("p01"), std::string::npos);
}

TEST_F(CampaignProgramTest, WrongUsageIsNamed) {
  Begin();
  ExpectRefused(Run({}), 2, {"subcommand"});
  ExpectRefused(Run({"add", Study(), "--id", "p01", "--hand", "middle", "--from", "x"}), 2, {"middle"});
  ExpectRefused(Run({"add", Study(), "--id", "p01", "--hand", "left"}), 2, {"--from"});
  ExpectRefused(Run({"add", Study(), "--id", "p01", "--from", "x"}), 2, {"--hand"});
  ExpectRefused(Run({"add", Study(), "--id", "p01", "--hand", "left", "--from", "x", "--sex", "man"}), 2,
                {"--sex"});
  ExpectRefused(Run({"add", Study(), "--id", "../x1", "--consent-date", "2024-05-31"}), 2, {"never a name"});
  ExpectRefused(Run({"add", Study(), "--id", "p02"}), 2, {"consent"});
  ExpectRefused(Run({"add", Study(), "--id", "p02", "--consent-date", "2999-01-01"}), 2, {"future"});
  ExpectRefused(Run({"remove", Study(), "--id", "p01", "--capture", "1"}), 2, {"--"});
  ExpectRefused(Run({"new", Study()}), 3, {"is a campaign already"});
  ExpectRefused(Run({"status", *this / "out"}), 3, {"no campaign"});
  ExpectRefused(Run({"verify", *this / "none"}), 3, {"no campaign"});
  ExpectRefused(Person("p01"), 3, {"p01"});
  for (const char* command : {"new", "add", "status", "verify", "export", "remove"}) {
    const ProgramRun help = Run({command, "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find("Example: dorsum campaign " + std::string(command)), std::string::npos);
  }
}

// At whatever moment: what counts is whole, what is not whole does not count, and the next command goes on.
TEST_F(CampaignProgramTest, KilledAtAnyMomentNoHalfCaptureCounts) {
  Begin();
  int kept = 0, killed = 0;
  for (int i = 0; i < 24; ++i) {
    const ProgramRun run = Run(Import(i, i % 2 == 0 ? "left" : "right"), [&](pid_t pid) {
      std::this_thread::sleep_for(std::chrono::microseconds(2000 * i));
      kill(pid, SIGKILL);
    });
    run.code == 0 ? ++kept : ++killed;
    const int captures = Captures();
    EXPECT_TRUE(captures == kept || captures == kept + 1) << "it may have counted just before the kill";
    kept = captures;
    // Each finding, if any, is of what the next command clears.
    const Json findings = Json::parse(Run({"verify", Study(), "--json"}).out, nullptr, false)["findings"];
    for (const Json& finding : findings) {
      const std::string text = finding;
      EXPECT_TRUE(text.find("killed") != std::string::npos || text.find(".part") != std::string::npos ||
                  text.find("manifest.json") != std::string::npos)
          << text;
    }
  }
  EXPECT_GT(killed, 0);
  EXPECT_EQ(Run(Import(100)).code, 0);
  EXPECT_EQ(Captures(), kept + 1);
  EXPECT_EQ(Run({"verify", Study()}).code, 0) << "the command before has cleared all";
}

TEST_F(CampaignProgramTest, TwoProcessesAddAtOnce) {
  Begin();
  const std::vector<std::string> first = Import(1), second = Import(2);
  std::vector<std::string> words = {"campaign"};
  words.insert(words.end(), second.begin(), second.end());
  int code = -1;
  const ProgramRun run = Run(first, [&](pid_t) {
    // RunProgram keeps its output in a folder of the test's name, so the other one is started by hand.
    words.insert(words.begin(), DORSUM_PROGRAM);
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t pid = 0;
    ASSERT_EQ(posix_spawn(&pid, DORSUM_PROGRAM, nullptr, nullptr, argv.data(), environ), 0);
    waitpid(pid, &code, 0);
  });
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(code, 0);
  EXPECT_EQ(Captures(), 2);
  EXPECT_EQ(Run({"verify", Study()}).code, 0);
}

TEST_F(CampaignProgramTest, ADeviceCapturesForTheCampaign) {
  Begin();
  std::string device = ScanFixture::kDevice;
  device.insert(device.find("[camera]\n") + 9,
                std::string("source = \"virtual:") + ScanFixture::kSeed + "\"\n");
  ASSERT_TRUE(WriteFile(*this / "device.toml", device).ok());
  const ProgramRun added = Run({"add", Study(), "--id", "p01", "--hand", "left", "--device",
                                *this / "device.toml", "-c", ScanFixture::CalibrationJson()});
  ASSERT_EQ(added.code, 0) << added.err;
  EXPECT_EQ(Captures(), 1);
  EXPECT_EQ(Run({"verify", Study()}).code, 0);
  ExpectRefused(Run({"add", Study(), "--id", "p01", "--hand", "left", "--device", *this / "none.toml"}), 3,
                {"none.toml"});
  EXPECT_EQ(Captures(), 1);
}

TEST_F(CampaignProgramTest, AVirtualCampaignIsInterruptedAndGoesOn) {
  const std::vector<std::string> words = {"new",       Study(),
                                          "--virtual", ScanFixture::kSeed,
                                          "--people",  "1",
                                          "--hands",   "left",
                                          "--device",  ScanFixture::Scan() / "device.toml",
                                          "-c",        ScanFixture::CalibrationJson()};
  const fs::path first = fs::path(Study()) / "people/id00/person.json";
  const ProgramRun interrupted = Run(words, [&](pid_t pid) {
    for (int i = 0; i < 6000 && !fs::exists(first); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(pid, SIGINT);
  });
  ExpectRefused(interrupted, 130, {"interrupted"});
  EXPECT_EQ(Run({"verify", Study()}).code, 0);
  const ProgramRun rest = Run(words);
  EXPECT_EQ(rest.code, 0) << rest.err;
  EXPECT_EQ(Captures(), 1);
  EXPECT_EQ(Run({"verify", Study()}).code, 0);
}

}  // namespace
}  // namespace dorsum
