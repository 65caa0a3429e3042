// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_names.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "captures/names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// Not std::isalnum: it asks the locale.
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

int CampaignSession::Count(CampaignHand hand) const {
  return static_cast<int>(std::count_if(captures.begin(), captures.end(),
                                        [&](const StoredCapture& c) { return c.hand == hand; }));
}

const StoredCapture* CampaignSession::Find(CampaignHand hand, int capture) const {
  for (const StoredCapture& c : captures) {
    if (c.hand == hand && c.number == capture) return &c;
  }
  return nullptr;
}

std::string CampaignCapture::Name() const {
  return id + "_s" + std::to_string(session) + "_" + HandWord(stored.hand) + "_k" +
         std::to_string(stored.number);
}

fs::path CampaignCapture::Folder(const fs::path& campaign) const {
  return CaptureFolder(campaign, id, session, {stored.hand, stored.number});
}

const std::vector<std::string>& CampaignSexes() {
  static const std::vector<std::string> kSexes = {"man", "woman", "other", "not-said"};
  return kSexes;
}

const std::vector<std::string>& CampaignAgeGroups() {
  static const std::vector<std::string> kGroups = {"under-20", "20-29", "30-39",   "40-49",
                                                   "50-59",    "60-69", "over-69", "not-said"};
  return kGroups;
}

const char* HandWord(CampaignHand hand) { return hand == CampaignHand::kLeft ? "left" : "right"; }

std::optional<CampaignHand> HandOfWord(const std::string& word) {
  if (word == "left") return CampaignHand::kLeft;
  if (word == "right") return CampaignHand::kRight;
  return std::nullopt;
}

Status CheckPersonId(const std::string& id) {
  const auto allowed = [](char c) { return IsDigit(c) || IsLetter(c) || c == '-' || c == '_'; };
  const bool fine = !id.empty() && id.size() <= 32 && (IsDigit(id[0]) || IsLetter(id[0])) &&
                    std::all_of(id.begin(), id.end(), allowed) && std::any_of(id.begin(), id.end(), IsDigit);
  if (fine) return {};
  return UsageError(
      "a person's id is 1 to 32 letters a to z, digits, - and _, with at least one digit and neither - nor _ "
      "in front: p01, never a name");
}

Status CheckCampaignName(const std::string& name) {
  const bool fine = !name.empty() && name.size() <= 100 && std::none_of(name.begin(), name.end(), [](char c) {
    return (c >= 0 && c < ' ') || c == '\x7f';
  });
  if (fine) return {};
  return UsageError("a campaign's name has 1 to 100 characters, all of them printable");
}

Status CheckConsentDate(const std::string& date, const std::string& today) {
  bool fine = date.size() == 10;
  for (std::size_t i = 0; fine && i < date.size(); ++i) {
    fine = i == 4 || i == 7 ? date[i] == '-' : IsDigit(date[i]);
  }
  if (fine) {
    using namespace std::chrono;
    fine = year_month_day(year(std::stoi(date.substr(0, 4))),
                          month(static_cast<unsigned>(std::stoi(date.substr(5, 2)))),
                          day(static_cast<unsigned>(std::stoi(date.substr(8, 2)))))
               .ok();
  }
  if (!fine) {
    return UsageError(
        "the consent date must be a day that exists, as 2024-05-31; without consent nothing is "
        "stored");
  }
  if (date < "1990-01-01") return UsageError("the consent date " + date + " is before 1990");
  if (date > today) {
    return UsageError("the consent date " + date + " lies in the future (today is " + today +
                      "); without consent nothing is stored");
  }
  return {};
}

std::string Today() {
  const std::time_t now = std::time(nullptr);
  std::tm day{};
  localtime_r(&now, &day);
  char text[16] = "";
  std::strftime(text, sizeof text, "%Y-%m-%d", &day);
  return text;
}

bool IsSha256(const std::string& text) {
  return text.size() == 64 &&
         std::all_of(text.begin(), text.end(), [](char c) { return IsDigit(c) || (c >= 'a' && c <= 'f'); });
}

std::vector<std::string> PictureStems() {
  std::vector<std::string> stems = {kBgHandName, kBgHandAfterName};
  for (int laser = 0; laser < kMaxLasers; ++laser) stems.push_back(StripesHandName(laser));
  return stems;
}

bool IsPictureName(const std::string& name) {
  for (const std::string& stem : PictureStems()) {
    if (name == stem + ".png" || name == stem + ".jpg") return true;
  }
  return false;
}

fs::path PersonFolder(const fs::path& dir, const std::string& id) { return dir / kPeopleFolder / id; }

fs::path SessionFolder(const fs::path& dir, const std::string& id, int session) {
  return PersonFolder(dir, id) / kSessionsFolder / std::to_string(session);
}

fs::path CaptureFolder(const fs::path& dir, const std::string& id, int session, CaptureKey key) {
  return SessionFolder(dir, id, session) / HandWord(key.hand) / std::to_string(key.number);
}

fs::path CalibrationFile(const fs::path& dir, const std::string& sha256) {
  return dir / kCalibrationsFolder / (sha256 + ".json");
}

}  // namespace dorsum
