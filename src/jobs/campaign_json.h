// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

// What the JSON files of a campaign share: the seal (a last key `sha256` over all that stands before it) and
// words that several of them hold.

inline constexpr int kCampaignSchemaVersion = 1;

Json StartSealed(const char* schema);
Status WriteSealed(const std::filesystem::path& path, Json json);
// The object without its seal; refused when it is torn or the seal does not fit.
Result<Json> ReadSealed(const std::filesystem::path& path);

// Readers of single values; what no campaign can hold becomes the reader's error.
std::string WordOf(JsonReader* reader, const std::string& key, const std::vector<std::string>& words);
CampaignHand HandOf(JsonReader* reader);                             // `hand`
std::string HashOrNone(JsonReader* reader, const std::string& key);  // a SHA-256 or nothing
std::vector<int> LasersOf(JsonReader* reader);                       // `lasers`, ascending

}  // namespace dorsum
