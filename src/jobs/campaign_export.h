// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"

namespace dorsum {

struct ExportRequest {
  std::filesystem::path dir, out_dir;  // out_dir must not exist or be empty
  bool groups = false;                 // also sex and a coarse age group (under-40, 40-59, over-59)
  int least = 5;  // people, 2 to 1000: a group with fewer is not told, and then the attribute of nobody is
};

struct ExportSummary {
  int people = 0, captures = 0;
  std::vector<std::string> attributes;  // told: sex, age_group
  std::vector<std::string> warnings;    // one sentence each
};

// The job behind `dorsum campaign export`: the captures for others, without what says who they are of. Each
// person has a new random id, kept nowhere; there is no consent date, no path and no order of coming.
// Pictures keep their pixels and lose all else (captures/picture_metadata.h); calibrations lose the names of
// the files that they were made from. All file times are the same day. OUT/captures/NAME are capture folders
// side by side, as `reconstruct --batch` takes them; OUT/SHA256SUMS is for sha256sum --check.
//
// A picture of a hand stays biometric data of a person: an export hides who it is from the reader, not from
// someone who has another picture of the same hand.
Result<ExportSummary> ExportCampaign(const ExportRequest& request, const Context& context);

}  // namespace dorsum
