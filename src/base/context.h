// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

#include "base/result.h"

namespace dorsum {

class StageSink;  // imaging/stage_sink.h

// What a long job needs from whoever runs it: how many threads, where progress goes, whether to stop.
// The command line and the window run the same jobs with different contexts.
struct Context {
  int threads = 0;  // 0: one per processor; results do not depend on it
  // Called from the job's own thread with a stage's name and the share done, in [0, 1].
  std::function<void(std::string_view stage, double fraction)> progress;
  const std::atomic<bool>* cancel = nullptr;  // set by the owner to stop the job at its next check
  StageSink* sink = nullptr;                  // receives intermediate images; none by default

  void Report(std::string_view stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }
  bool IsCancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  Status CheckCancelled() const { return IsCancelled() ? Status(Cancelled()) : Status(); }
};

}  // namespace dorsum
