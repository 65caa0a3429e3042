// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "base/result.h"
#include "jobs/campaign_disk.h"

namespace dorsum {

// What a killed command had left, and is gone now.
struct Recovered {
  int removals = 0;  // people whose deletion is finished now
  int captures = 0;  // captures that had not come whole, or had not gone whole
};

// Brings a campaign to rest after a kill or a power cut at any moment: finishes deletions, and clears what a
// capture had not finished. Nothing that a manifest counts is touched, and nothing that dorsum did not put
// there; a manifest that cannot be read is left for `verify` to tell. The lock, a writer's, is to have been
// taken.
Result<Recovered> RecoverCampaign(const std::filesystem::path& dir, const CampaignLock& lock);

}  // namespace dorsum
