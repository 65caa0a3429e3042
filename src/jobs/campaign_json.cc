// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_json.h"

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "captures/names.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSeal = "sha256";

std::string SealOf(const Json& json) {
  return Sha256Hex(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

Status WriteSealed(const fs::path& path, Json json) {
  json[kSeal] = SealOf(json);
  return WriteDurably(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Result<Json> ReadSealed(const fs::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadFile(path, std::size_t{64} << 20));
  Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return BadInput(path.string() + " is not valid JSON; restore it from a copy");
  Json seal;
  if (const auto it = json.find(kSeal); it != json.end()) {
    seal = *it;
    json.erase(it);
  }
  if (!seal.is_string() || seal.get<std::string>() != SealOf(json)) {
    return BadInput(path.string() +
                    " was changed since dorsum wrote it: its checksum is wrong; restore it from a copy");
  }
  return json;
}

Json StartSealed(const char* schema) { return {{"schema", schema}, {"version", kCampaignSchemaVersion}}; }

std::string WordOf(JsonReader* reader, const std::string& key, const std::vector<std::string>& words) {
  std::string word = reader->Text(key);
  if (std::find(words.begin(), words.end(), word) == words.end()) reader->Fail(key, "is not an allowed word");
  return word;
}

CampaignHand HandOf(JsonReader* reader) {
  const auto hand = HandOfWord(reader->Text("hand"));
  if (!hand) reader->Fail("hand", "must be left or right");
  return hand.value_or(CampaignHand::kLeft);
}

std::string HashOrNone(JsonReader* reader, const std::string& key) {
  std::string hash = reader->Text(key);
  if (!hash.empty() && !IsSha256(hash)) reader->Fail(key, "must be a SHA-256 or empty");
  return hash;
}

std::vector<int> LasersOf(JsonReader* reader) {
  std::vector<int> lasers;
  for (const double laser : reader->Numbers("lasers", -1, 0, kMaxLasers - 1)) {
    lasers.push_back(static_cast<int>(laser));
    if (lasers.back() != laser || (lasers.size() > 1 && lasers.back() <= lasers[lasers.size() - 2])) {
      reader->Fail("lasers", "must be whole numbers that grow");
      break;
    }
  }
  return lasers;
}

}  // namespace dorsum
