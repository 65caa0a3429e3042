// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <toml++/toml.h>

#include "base/result.h"

namespace dorsum {

// A human-written settings file; the error names file, line and reason.
Result<toml::table> ReadTomlFile(const std::filesystem::path& path);

}  // namespace dorsum
