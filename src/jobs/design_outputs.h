// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "jobs/design.h"

namespace dorsum {

// Writes device.toml, design.json, design.png and design.html into a folder, all or nothing, and returns
// their names.
Result<std::vector<std::string>> WriteDesign(const DesignSummary& summary,
                                             const std::filesystem::path& out_dir);

}  // namespace dorsum
