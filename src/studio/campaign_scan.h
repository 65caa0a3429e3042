// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "jobs/campaign.h"
#include "studio/workbench.h"

namespace dorsum {

// Reads a capture of the campaign in `dir` and reconstructs it with the calibration that it was stored with.
Result<std::shared_ptr<const Scan>> ScanOfCapture(const CampaignCapture& capture,
                                                  const std::filesystem::path& dir, const Context& context);

}  // namespace dorsum
