// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

// The words and file names of a campaign, and what may be written into it.

inline constexpr const char* kCampaignJson = "campaign.json";
inline constexpr const char* kCampaignLock = "campaign.lock";
inline constexpr const char* kPersonJson = "person.json";
inline constexpr const char* kSessionManifest = "manifest.json";
inline constexpr const char* kPeopleFolder = "people";
inline constexpr const char* kSessionsFolder = "sessions";
inline constexpr const char* kCalibrationsFolder = "calibrations";
inline constexpr const char* kWorkPrefix = ".working-";     // a folder that a running command fills
inline constexpr const char* kRemovePrefix = ".removing-";  // a person who is being deleted

inline constexpr int kMaxPeople = 10000;
inline constexpr int kMaxSessions = 100;
inline constexpr int kMaxCaptures = 100;  // of one hand in one session

const std::vector<std::string>& CampaignSexes();      // man, woman, other, not-said
const std::vector<std::string>& CampaignAgeGroups();  // decades, not-said

const char* HandWord(CampaignHand hand);  // "left" or "right"
std::optional<CampaignHand> HandOfWord(const std::string& word);

// A pseudonymous id: 1 to 32 letters (a–z), digits, - and _, beginning with a letter or digit; at least one
// digit, so that nobody enters a name by mistake. A usage error says so.
Status CheckPersonId(const std::string& id);
// A name for people to read: 1 to 100 bytes without control characters.
Status CheckCampaignName(const std::string& name);
// A day that exists, YYYY-MM-DD, from 1990 to `today` (of the same form).
Status CheckConsentDate(const std::string& date, const std::string& today);
// The local date, YYYY-MM-DD.
std::string Today();

bool IsSha256(const std::string& text);  // 64 lower-case hex digits
// bgHand, stripesHand0 … 7 and bgHandAfter, with the extension png or jpg: all that a capture may hold.
bool IsPictureName(const std::string& name);
std::vector<std::string> PictureStems();

std::filesystem::path PersonFolder(const std::filesystem::path& dir, const std::string& id);
std::filesystem::path SessionFolder(const std::filesystem::path& dir, const std::string& id, int session);
std::filesystem::path CaptureFolder(const std::filesystem::path& dir, const std::string& id, int session,
                                    CaptureKey key);
std::filesystem::path CalibrationFile(const std::filesystem::path& dir, const std::string& sha256);

}  // namespace dorsum
