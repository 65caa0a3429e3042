// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace dorsum {

// How long the window's thread once did not come to a timer that is due every 5 ms, and how long a thread
// that does nothing else did not come to its own meanwhile: that much the machine is to blame for.
class LoopProbe {
 public:
  LoopProbe() : beside_([this] { WatchBeside(); }) {
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, [this] { Tick(); });
    clock_.start();
    timer_.start(kEvery_ms);
  }
  LoopProbe(const LoopProbe&) = delete;
  LoopProbe& operator=(const LoopProbe&) = delete;
  ~LoopProbe() {
    stop_ = true;
    beside_.join();
  }

  double longest_ms() {
    Tick();
    return longest_ms_;
  }
  void Restart() { clock_.restart(); }  // what the window did since its last tick does not count
  double longest_beside_ms() const { return longest_beside_ms_; }

 private:
  static constexpr int kEvery_ms = 5;

  void Tick() {
    longest_ms_ = std::max(longest_ms_, 1e-6 * static_cast<double>(clock_.nsecsElapsed()));
    clock_.restart();
  }
  void WatchBeside() {
    QElapsedTimer clock;
    clock.start();
    while (!stop_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(kEvery_ms));
      longest_beside_ms_ =
          std::max(longest_beside_ms_.load(), 1e-6 * static_cast<double>(clock.nsecsElapsed()));
      clock.restart();
    }
  }

  QTimer timer_;
  QElapsedTimer clock_;
  double longest_ms_ = 0.0;
  std::atomic<double> longest_beside_ms_ = 0.0;
  std::atomic<bool> stop_ = false;
  std::thread beside_;
};

}  // namespace dorsum
