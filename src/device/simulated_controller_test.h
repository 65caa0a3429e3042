// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dorsum {

// The light controller's firmware running in simavr, in a process of its own (tests/simulated_controller).
// Times are its own, in simulated seconds: they do not depend on how fast the machine is.
class SimulatedController {
 public:
  struct Event {
    double time_s = 0.0;
    std::string kind, text;  // "reset" "open"; "pins" "0000lllll"; "time" ""
    unsigned lit = 0;        // of "pins": bit n for channel n
  };

  static bool Available() {
#ifdef DORSUM_SIMULATED_CONTROLLER
    return true;
#else
    return false;
#endif
  }

  // `firmware` is "dorsum-controller" or another of firmware/CMakeLists.txt.
  explicit SimulatedController(const std::string& firmware = "dorsum-controller",
                               const std::vector<std::string>& options = {}) {
#ifdef DORSUM_SIMULATED_CONTROLLER
    std::vector<std::string> words = {DORSUM_SIMULATED_CONTROLLER,
                                      std::string(DORSUM_FIRMWARE_DIR) + "/" + firmware + ".hex"};
    words.insert(words.end(), options.begin(), options.end());
    Start(words);
#else
    static_cast<void>(firmware);
    static_cast<void>(options);
#endif
  }
  SimulatedController(const SimulatedController&) = delete;
  SimulatedController& operator=(const SimulatedController&) = delete;
  ~SimulatedController() {
    if (to_ != nullptr) std::fclose(to_);  // it ends with its input
    if (reader_.joinable()) reader_.join();
    if (pid_ > 0) waitpid(pid_, nullptr, 0);
  }

  const std::string& port() const { return port_; }

  void Command(const std::string& word) {
    std::fprintf(to_, "%s\n", word.c_str());
    std::fflush(to_);
  }

  std::vector<Event> Log() {
    const std::lock_guard lock(mutex_);
    return events_;
  }

  // Waits until the log fulfils it. A generous half minute of the wall's: only a failure takes so long.
  bool WaitFor(const std::function<bool(const std::vector<Event>&)>& fulfilled) {
    std::unique_lock lock(mutex_);
    return grown_.wait_for(lock, std::chrono::seconds(30), [&] { return fulfilled(events_); });
  }
  bool WaitForLit(unsigned lit) {
    return WaitFor([lit](const auto& events) { return LastLit(events) == lit; });
  }

  // What time it is now in there.
  double Now() {
    const auto count = [](const std::vector<Event>& events) {
      return std::count_if(events.begin(), events.end(), [](const Event& one) { return one.kind == "time"; });
    };
    const auto before = count(Log());
    Command("time");
    EXPECT_TRUE(WaitFor([&](const auto& events) { return count(events) > before; }));
    double now_s = 0.0;
    for (const Event& event : Log()) {
      if (event.kind == "time") now_s = event.time_s;
    }
    return now_s;
  }

  static unsigned LastLit(const std::vector<Event>& events) {
    unsigned lit = 0;
    for (const Event& event : events) {
      if (event.kind == "pins") lit = event.lit;
    }
    return lit;
  }
  // When the pins changed last.
  double LastChange() {
    double time_s = 0.0;
    for (const Event& event : Log()) {
      if (event.kind == "pins") time_s = event.time_s;
    }
    return time_s;
  }
  // Every set of lights that was ever lit, in order.
  std::vector<unsigned> LitSets() {
    std::vector<unsigned> sets;
    for (const Event& event : Log()) {
      if (event.kind == "pins" && event.lit != 0) sets.push_back(event.lit);
    }
    return sets;
  }
  int Resets() {
    int count = 0;
    for (const Event& event : Log()) count += event.kind == "reset" ? 1 : 0;
    return count;
  }

 private:
  void Start(const std::vector<std::string>& words) {
    int in[2] = {-1, -1}, out[2] = {-1, -1};
    ASSERT_EQ(pipe2(in, O_CLOEXEC), 0);
    ASSERT_EQ(pipe2(out, O_CLOEXEC), 0);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, in[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, out[1], STDOUT_FILENO);
    std::vector<std::string> copies = words;
    std::vector<char*> argv;
    argv.reserve(copies.size() + 1);
    for (std::string& word : copies) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int failed = posix_spawn(&pid_, argv[0], &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    close(in[0]);
    close(out[1]);
    ASSERT_EQ(failed, 0) << "cannot start " << words[0];
    to_ = fdopen(in[1], "w");
    reader_ = std::thread([this, from = out[0]] { ReadLog(from); });
    ASSERT_TRUE(WaitFor([](const auto& events) { return !events.empty(); })) << "no firmware";
  }

  void ReadLog(int from) {
    FILE* file = fdopen(from, "r");
    char line[256];
    while (std::fgets(line, sizeof line, file) != nullptr) {
      char word[64] = "", kind[16] = "", text[64] = "";
      unsigned lit = 0;
      const int count = std::sscanf(line, "%63s %15s %63s %x", word, kind, text, &lit);
      const std::lock_guard lock(mutex_);
      if (std::string(word) == "port") {
        port_ = std::string(line).substr(5);
        port_.erase(port_.find_last_not_of('\n') + 1);
      } else if (count >= 2) {
        events_.push_back({std::atof(word), kind, text, lit});
      }
      grown_.notify_all();
    }
    std::fclose(file);
  }

  pid_t pid_ = 0;
  FILE* to_ = nullptr;
  std::thread reader_;
  std::mutex mutex_;
  std::condition_variable grown_;
  std::vector<Event> events_;
  std::string port_;  // known before the first event
};

}  // namespace dorsum
