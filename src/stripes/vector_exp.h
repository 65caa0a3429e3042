// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace dorsum {

// Replaces values of -87 to 88 by their exp, to about 1e-7 of it, the same on every machine.
void RaiseToExp(std::span<float> values);

}  // namespace dorsum
