// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace dorsum::accuracy {

// One design of device, the seeds that name true devices of it, and what each of them captures.
struct DesignPlan {
  std::string name;              // the group in asked.toml
  std::filesystem::path device;  // device.toml, relative to the plan's folder
  std::vector<std::string> tuning, held_out, scenes;
  bool in_default_run = true;  // false: only when asked for by name
};

Result<std::vector<DesignPlan>> ReadPlan(const std::filesystem::path& path);

}  // namespace dorsum::accuracy
