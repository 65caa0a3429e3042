// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace dorsum::speed {

struct ChildUse {
  double seconds = 0.0;  // from start to end
  double peak_mb = 0.0;  // largest resident memory
};

// Runs a program to its end, with its standard output thrown away. `command`: its path and arguments. An
// error where it cannot be started or does not end with 0.
Result<ChildUse> RunChild(const std::vector<std::string>& command);

}  // namespace dorsum::speed
