// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/json.h"
#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

// Captures of one hand that the plan asks for and nobody took yet.
struct MissingCaptures {
  std::string id;
  int session = 0;
  CampaignHand hand = CampaignHand::kLeft;
  int count = 0;
};

// How a reconstruction of the whole campaign went (`dorsum reconstruct CAMPAIGN -o OUT --batch`). What the
// pictures are worth shows only there: before it, a campaign knows that they are whole and show something.
struct CampaignQuality {
  int reconstructed = 0, failed = 0, not_tried = 0;
  int with_warnings = 0;                            // of the reconstructed
  std::size_t least_points = 0, median_points = 0;  // of the reconstructed
  std::vector<std::string> failures;                // names of captures; summary.csv says why
};

struct CampaignStatus {
  Campaign campaign;
  int people = 0, complete = 0;                  // complete: has all that the plan asks for
  std::map<std::string, int> sexes, age_groups;  // people by the words of CampaignSexes() …
  int hands = 0;                                 // with a capture at least
  int sessions = 0, captures = 0, planned_captures = 0;
  int lacking_laser = 0;        // captures without a picture of each of the device's lasers
  int without_calibration = 0;  // captures
  int calibrations = 0;         // different ones among the captures
  std::uint64_t bytes = 0;      // of the pictures
  std::vector<MissingCaptures> missing;
  std::vector<std::string> problems;  // what could not be read and does not count; verify says more
  std::optional<CampaignQuality> quality;
};

// The job behind `dorsum campaign status`. `surfaces`: the folder of a batch reconstruction, or empty.
Result<CampaignStatus> StatusOfCampaign(const std::filesystem::path& dir,
                                        const std::filesystem::path& surfaces, const Context& context);

Json StatusToJson(const CampaignStatus& status);
std::string StatusToText(const CampaignStatus& status);

}  // namespace dorsum
