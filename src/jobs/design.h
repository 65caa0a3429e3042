// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "jobs/design_changes.h"
#include "jobs/design_report.h"
#include "jobs/design_search.h"

namespace dorsum {

struct DesignRequest {
  std::filesystem::path device_path;             // device.toml; empty: the built-in four-laser device
  DesignChanges changes;                         // over what it says
  std::vector<double> hand_mm = {190.0, 110.0};  // the hand area, across and along the stripes, 10 to 1000
  SurfaceAssumption surface;
  std::optional<DesignSearch> search;  // the reverse question
  std::filesystem::path out_dir;       // empty: nothing is written
};

struct DesignSummary {
  DesignReport report;  // of the device asked for, or of the search's best
  std::optional<SearchResult> search;
  std::vector<std::string> files;  // written, relative to out_dir
};

// The job behind `dorsum design` (§2.5): lays the device out as described and says what it will measure, or
// searches for the best. With an out_dir writes device.toml, which simulate takes, design.json, design.png
// and design.html; all or nothing.
Result<DesignSummary> Design(const DesignRequest& request, const Context& context);

std::string SummaryToText(const DesignSummary& summary);
Json SummaryToJson(const DesignSummary& summary);

}  // namespace dorsum
