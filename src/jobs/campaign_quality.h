// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "jobs/campaign.h"
#include "jobs/campaign_status.h"

namespace dorsum {

// Looks up each capture in what a batch reconstruction wrote: its summary.csv, and the report.json of those
// that went well.
Result<CampaignQuality> ReadQuality(const std::filesystem::path& surfaces,
                                    const std::vector<CampaignCapture>& captures);

}  // namespace dorsum
