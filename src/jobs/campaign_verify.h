// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/json.h"
#include "base/result.h"

namespace dorsum {

struct CampaignVerification {
  int people = 0, captures = 0, files = 0;  // whose checksums were compared
  std::uint64_t bytes = 0;
  std::vector<std::string> findings;  // one sentence each; none: all is as it was stored
};

// The job behind `dorsum campaign verify`: reads every byte. Finds what is missing, was changed, cannot be
// read or does not belong there, also what a killed command left. What other commands are adding at the same
// time is not looked at.
Result<CampaignVerification> VerifyCampaign(const std::filesystem::path& dir, const Context& context);

Json VerificationToJson(const CampaignVerification& verification);
std::string VerificationToText(const CampaignVerification& verification);

}  // namespace dorsum
