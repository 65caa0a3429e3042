// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "base/result.h"

namespace dorsum::accuracy {

// What a figure may be at least and at most.
struct Limit {
  std::optional<double> min, max;

  bool Holds(double value) const { return (!min || value >= *min) && (!max || value <= *max); }
  std::string Text() const;  // "≤ 0.06", "≥ 0.975", "0.85–1.2"
};

// By group ("four lasers / box"), then by figure (accuracy/score.h: Figures).
using LimitTable = std::map<std::string, std::map<std::string, Limit>>;

// A TOML file with a table for each group, whose keys are figures: z_rmse = { max = 0.06 }.
Result<LimitTable> ReadLimits(const std::filesystem::path& path);

Status WriteLimits(const std::filesystem::path& path, const std::string& comment, const LimitTable& limits);

}  // namespace dorsum::accuracy
