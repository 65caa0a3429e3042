// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace dorsum {

// Which of a job's reports a window is told: each new stage, and of one stage no more than the eye follows.
// A job may report thousands of times a second; each would make the window paint.
class ProgressGate {
 public:
  bool Passes(std::string_view stage) {
    const auto now = std::chrono::steady_clock::now();
    if (stage_ == stage && now - told_ < kEvery) return false;
    stage_ = std::string(stage);
    told_ = now;
    return true;
  }

 private:
  static constexpr auto kEvery = std::chrono::milliseconds(50);
  std::optional<std::string> stage_;
  std::chrono::steady_clock::time_point told_;
};

}  // namespace dorsum
