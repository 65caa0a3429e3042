// SPDX-License-Identifier: Apache-2.0
#include "device/frame_source.h"

#include <chrono>

namespace dorsum {

double MonotonicSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace dorsum
