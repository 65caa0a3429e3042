// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "captures/names.h"
#include "jobs/scan_fixture_test.h"

namespace dorsum {

// What a run of the program left: its exit code (-1 if a signal ended it), standard output and error.
struct ProgramRun {
  int code = -1;
  std::string out, err;
};

inline std::string WholeFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Runs `dorsum` with these arguments; `meanwhile` is called with its process id once it catches signals.
inline ProgramRun RunProgram(const std::vector<std::string>& arguments,
                             const std::function<void(pid_t)>& meanwhile = nullptr) {
  const TempFolder dir;  // of the test's name, so a test has only one beside it
  const std::string out = dir / "stdout", err = dir / "stderr";
  std::vector<std::string> words = {DORSUM_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t pid = 0;
  const int failed = posix_spawn(&pid, DORSUM_PROGRAM, &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  ProgramRun run;
  EXPECT_EQ(failed, 0) << "cannot start " << DORSUM_PROGRAM;
  if (failed != 0) return run;
  if (meanwhile) meanwhile(pid);
  int status = 0;
  waitpid(pid, &status, 0);
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.out = WholeFile(out);
  run.err = WholeFile(err);
  return run;
}

// Every file and folder below `dir`, hidden ones too.
inline std::set<std::string> Everything(const std::filesystem::path& dir) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(dir)) {
    names.insert(std::filesystem::relative(entry.path(), dir).string());
  }
  return names;
}

// A bad input's whole answer: the exit code, one line on the standard error that holds each of `culprits` and
// shows no innards, nothing on the standard output.
inline void ExpectRefused(const ProgramRun& run, int code, const std::vector<std::string>& culprits) {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.rfind("dorsum: error: ", 0), 0U) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(run.err.find(". "), std::string::npos) << "two sentences: " << run.err;
  for (const char* innards : {"std::", "OpenCV", "exception", "terminate", "nlohmann", "json.exc"}) {
    EXPECT_EQ(run.err.find(innards), std::string::npos) << run.err;
  }
  for (const std::string& culprit : culprits) {
    EXPECT_NE(run.err.find(culprit), std::string::npos) << culprit << " is not named: " << run.err;
  }
}

// A copy of the fixture's calibration folder or captures to damage, and a folder `out` of which nothing may
// be left.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest() : root_(Root()) {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_ / "out");
  }
  ~ProgramTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }

  std::filesystem::path operator/(const std::string& name) const { return root_ / name; }
  std::filesystem::path Series() {
    if (!std::filesystem::exists(root_ / "series"))
      ScanFixture::CopyFolder(ScanFixture::CalibrationDir(), root_ / "series");
    return root_ / "series";
  }
  std::filesystem::path Capture(const char* scene = ScanFixture::kBox) {
    if (!std::filesystem::exists(root_ / "capture"))
      ScanFixture::CopyFolder(ScanFixture::CaptureDir(scene), root_ / "capture");
    return root_ / "capture";
  }
  // Puts the image back as it was.
  void RestoreSeries(const std::string& name) {
    std::filesystem::copy_file(ScanFixture::CalibrationDir() / name, Series() / name,
                               std::filesystem::copy_options::overwrite_existing);
  }

  ProgramRun Calibrate() {
    return RunProgram({"calibrate", Series().string(), "-o", (root_ / "out" / "calibration.json").string()});
  }
  ProgramRun Reconstruct(const std::filesystem::path& calibration = ScanFixture::CalibrationJson(),
                         const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"reconstruct", Capture().string(),
                                          "-c",          calibration.string(),
                                          "-o",          (root_ / "out" / "hand").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments);
  }
  void ExpectNothingWritten() {
    EXPECT_TRUE(std::filesystem::is_empty(root_ / "out"))
        << "left behind: " << *Everything(root_ / "out").begin();
  }

 private:
  // Beside the TempFolder that bears the test's name.
  static std::filesystem::path Root() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    return std::filesystem::path(::testing::TempDir()) /
           (std::string("dorsum_program_") + info->name() + "_" + std::to_string(getpid()));
  }
  std::filesystem::path root_;
};

}  // namespace dorsum
