// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "captures/device_description.h"

namespace dorsum {

// The whole description as device.toml has it: every key, one on a line, numbers in as many digits as bring
// them back unchanged. A laser without a channel gets its number, as the reader gives it.
std::string DeviceDescriptionToToml(const DeviceDescription& device);

// ReadDeviceDescription of a text instead of a file; `where` stands for the file's name in errors.
Result<DeviceDescription> ParseDeviceDescription(std::string_view text, const std::string& where);

}  // namespace dorsum
