// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

// campaign.json, person.json and manifest.json (docs/formats.md). Each ends with the SHA-256 of all that
// stands before, so that a changed byte does not pass: reading refuses a file that is torn, was changed or
// holds what no campaign can hold, in one sentence. `dir` is the campaign's folder.

Result<Campaign> ReadCampaign(const std::filesystem::path& dir);
Status WriteCampaign(const std::filesystem::path& dir, const Campaign& campaign);

Result<CampaignPerson> ReadPerson(const std::filesystem::path& dir, const std::string& id);
Status WritePerson(const std::filesystem::path& dir, const CampaignPerson& person);

Result<CampaignSession> ReadSession(const std::filesystem::path& dir, const std::string& id, int session);
Status WriteSession(const std::filesystem::path& dir, const std::string& id, const CampaignSession& session);

// Folder names that can be ids, whether or not a person.json is there; and numbers that can be sessions.
Result<std::vector<std::string>> ListPeople(const std::filesystem::path& dir);
Result<std::vector<int>> ListSessions(const std::filesystem::path& dir, const std::string& id);

// Every capture that counts, by id, session, hand and number. With `problems`, people and sessions that
// cannot be read are told there and left out; without, the first is the error.
Result<std::vector<CampaignCapture>> ListCaptures(const std::filesystem::path& dir,
                                                  std::vector<std::string>* problems = nullptr);

}  // namespace dorsum
