// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_quality.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "base/files.h"
#include "base/json.h"
#include "jobs/reconstruct_batch.h"
#include "jobs/reconstruct_outputs.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// The result of each capture by its name: the first two fields of each line. The names that are looked for
// need no quotes, and a line inside a quoted field is none of them.
std::map<std::string, std::string> Results(const std::string& csv) {
  std::map<std::string, std::string> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(','), second = line.find(',', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    rows[line.substr(0, first)] = line.substr(first + 1, second - first - 1);
  }
  return rows;
}

}  // namespace

Result<CampaignQuality> ReadQuality(const fs::path& surfaces, const std::vector<CampaignCapture>& captures) {
  DORSUM_ASSIGN_OR_RETURN(const std::string table, ReadFile(surfaces / kBatchTable, std::size_t{64} << 20));
  const std::map<std::string, std::string> results = Results(table);
  CampaignQuality quality;
  std::vector<std::size_t> points;
  for (const CampaignCapture& c : captures) {
    const auto row = results.find(c.Name());
    if (row == results.end()) {
      ++quality.not_tried;
      continue;
    }
    if (row->second == OutcomeText(BatchOutcome::kFailed)) {
      ++quality.failed;
      quality.failures.push_back(c.Name());
      continue;
    }
    const Result<Json> report = ReadJson(surfaces / c.Name() / kReportJson);
    if (!report.ok()) return report.error();
    const bool known = report->is_object() && report->contains("points") &&
                       (*report)["points"].is_number_unsigned() && report->contains("warnings") &&
                       (*report)["warnings"].is_array();
    if (!known) {
      return BadInput((surfaces / c.Name() / kReportJson).string() +
                      " does not say points and warnings; reconstruct again");
    }
    ++quality.reconstructed;
    points.push_back((*report)["points"].get<std::size_t>());
    if (!(*report)["warnings"].empty()) ++quality.with_warnings;
  }
  std::sort(points.begin(), points.end());
  if (!points.empty()) {
    quality.least_points = points.front();
    quality.median_points = points[points.size() / 2];
  }
  return quality;
}

}  // namespace dorsum
