// SPDX-License-Identifier: Apache-2.0
#include <csignal>

#include <gtest/gtest.h>

#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// Whether the process catches the signal, as /proc says; also true when there is no such process any more.
bool Catches(pid_t pid, int signal) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  std::string word;
  while (status >> word) {
    if (word != "SigCgt:") continue;
    status >> word;
    return (std::stoull(word, nullptr, 16) >> (signal - 1) & 1U) != 0;
  }
  return true;
}

// Sends the signal `delay_ms` after the program began to catch it. `posix_spawn` returns before the program
// has come so far, and until then a signal would simply end it.
ProgramRun Interrupted(const std::vector<std::string>& arguments, int delay_ms, int signal = SIGINT) {
  return RunProgram(arguments, [&](pid_t pid) {
    while (!Catches(pid, signal)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    kill(pid, signal);
  });
}

class InterruptTest : public ProgramTest {};

TEST_F(InterruptTest, CalibrateStopsAndLeavesNothing) {
  for (const int delay_ms : {0, 150}) {
    const ProgramRun run = Interrupted(
        {"calibrate", ScanFixture::CalibrationDir(), "-o", *this / "out" / "c.json", "--threads", "1"},
        delay_ms);
    ExpectRefused(run, 130, {"interrupted"});
    ExpectNothingWritten();
  }
}

TEST_F(InterruptTest, ReconstructStopsAndLeavesNothing) {
  for (const int delay_ms : {0, 60}) {
    const ProgramRun run =
        Interrupted({"reconstruct", ScanFixture::CaptureDir(ScanFixture::kHand), "-c",
                     ScanFixture::CalibrationJson(), "-o", *this / "out" / "hand", "--threads", "1"},
                    delay_ms);
    ExpectRefused(run, 130, {"interrupted"});
    ExpectNothingWritten();
  }
}

TEST_F(InterruptTest, SimulateStopsAndLeavesNothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ProgramRun run = Interrupted({"simulate", "-o", *this / "out" / "below" / "scan"}, 400, signal);
    ExpectRefused(run, 130, {"interrupted"});
    ExpectNothingWritten();
  }
}

}  // namespace
}  // namespace dorsum
