// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "base/result.h"

namespace dorsum {

// Camera or controller do not do what they should: exit code 4. One sentence that says what to do.
inline Error DeviceError(std::string message) { return {ErrorCode::kDevice, std::move(message)}; }

}  // namespace dorsum
