// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

struct GatheredPictures {
  std::vector<StoredPicture> pictures;  // by name
  CampaignDevice device;                // the campaign's, or taken from the pictures where that is empty
  std::vector<int> lasers;              // whose pictures are there
  std::vector<std::string> warnings;    // one sentence each
};

// Makes a new capture folder fit to be stored: checks it with LoadCapture against the campaign's device,
// gives each picture its plain name (by what the file is: png or jpg), removes all that is no picture of a
// capture, syncs the rest to disk and takes the checksums. Messages call the folder `source`.
Result<GatheredPictures> GatherPictures(const std::filesystem::path& folder, const CampaignDevice& device,
                                        const std::string& source);

}  // namespace dorsum
