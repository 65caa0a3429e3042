// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

namespace dorsum {

// A pseudo-terminal of the test's own.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
    EXPECT_GE(master_, 0);
    EXPECT_EQ(grantpt(master_), 0);
    EXPECT_EQ(unlockpt(master_), 0);
    name_ = ptsname(master_);
    slave_ = open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    MakeRaw(slave_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() { Close(); }

  // As a cable that is pulled out.
  void Close() {
    if (slave_ >= 0) close(slave_);
    if (master_ >= 0) close(master_);
    slave_ = master_ = -1;
  }

  int master() const { return master_; }
  const std::string& name() const { return name_; }

  static void MakeRaw(int handle) {
    termios settings = {};
    ASSERT_EQ(tcgetattr(handle, &settings), 0);
    cfmakeraw(&settings);
    ASSERT_EQ(tcsetattr(handle, TCSANOW, &settings), 0);
  }

 private:
  int master_, slave_ = -1;  // our own hold on the slave keeps what is written there until somebody reads it
  std::string name_;
};

enum class Mischief { kLose, kDouble, kGarble };
enum class Way { kToController, kToHost };

// A man in the middle: passes bytes between a port and a pseudo-terminal of its own, and does one byte harm
// when it is told to.
class SerialRelay {
 public:
  explicit SerialRelay(const std::string& port) : far_(open(port.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    EXPECT_GE(far_, 0) << port;
    Terminal::MakeRaw(far_);
    pump_ = std::thread([this] { Pump(); });
  }
  SerialRelay(const SerialRelay&) = delete;
  SerialRelay& operator=(const SerialRelay&) = delete;
  ~SerialRelay() { Cut(); }

  const std::string& port() const { return near_.name(); }

  // From now on: the byte number `at` that goes this way.
  void Arm(Way way, Mischief mischief, int at) {
    const std::lock_guard lock(mutex_);
    plan_ = Plan{way, mischief, at};
  }
  // Whether the armed harm has been done.
  bool Done() {
    const std::lock_guard lock(mutex_);
    return !plan_;
  }
  void Cut() {
    stop_ = true;
    if (pump_.joinable()) pump_.join();
    near_.Close();
    if (far_ >= 0) close(far_);
    far_ = -1;
  }

 private:
  struct Plan {
    Way way;
    Mischief mischief;
    int left;
  };

  std::string Harm(Way way, const char* bytes, ssize_t count) {
    const std::lock_guard lock(mutex_);
    std::string out;
    for (ssize_t i = 0; i < count; ++i) {
      if (!plan_ || plan_->way != way || plan_->left-- > 0) {
        out += bytes[i];
        continue;
      }
      if (plan_->mischief == Mischief::kDouble) out.append(2, bytes[i]);
      if (plan_->mischief == Mischief::kGarble) out += static_cast<char>(bytes[i] ^ 0x41);
      plan_.reset();
    }
    return out;
  }

  void Pass(Way way, int from, int to) {
    char bytes[256];
    const ssize_t count = read(from, bytes, sizeof bytes);
    if (count <= 0) return;
    const std::string out = Harm(way, bytes, count);
    EXPECT_EQ(write(to, out.data(), out.size()), static_cast<ssize_t>(out.size()));
  }

  void Pump() {
    while (!stop_) {
      pollfd ends[2] = {{near_.master(), POLLIN, 0}, {far_, POLLIN, 0}};
      if (poll(ends, 2, 20) <= 0) continue;
      if ((ends[0].revents & POLLIN) != 0) Pass(Way::kToController, near_.master(), far_);
      if ((ends[1].revents & POLLIN) != 0) Pass(Way::kToHost, far_, near_.master());
    }
  }

  Terminal near_;
  int far_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::optional<Plan> plan_;
  std::thread pump_;
};

}  // namespace dorsum
