// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dorsum {

// A campaign (§5.3): people who come to one device with both hands, and what was captured of them. What is on
// disk, docs/campaign.md; this header holds only values.

enum class CampaignHand { kLeft, kRight };

// What is to be captured of each person.
struct CampaignPlan {
  int people = 0;    // that are hoped for, 0 to 10000; 0: not said
  int sessions = 1;  // visits of each person, 1 to 100
  int captures = 1;  // of each hand in each session, 1 to 100
  std::vector<CampaignHand> hands = {CampaignHand::kLeft, CampaignHand::kRight};  // at least one
};

// The one device of a campaign, as far as its pictures show it.
struct CampaignDevice {
  std::string name;
  int width = 0, height = 0;  // px; 0 until the first capture or calibration tells
  std::vector<int> lasers;    // ascending; empty until then
};

// Where the people of a virtual campaign come from.
struct VirtualPeople {
  std::string seed;           // of device and people, as in `simulate --seed`
  int people = 20;            // 1 to 10000
  std::string device_sha256;  // of the device description; empty: the built-in device
};

struct Campaign {
  std::string name;
  CampaignPlan plan;
  CampaignDevice device;
  std::string calibration;  // SHA-256 of the one that new captures belong to; empty: none yet
  std::optional<VirtualPeople> virtual_people;
};

struct CampaignPerson {
  std::string id;            // pseudonymous (CheckPersonId)
  std::string sex;           // one of CampaignSexes()
  std::string age_group;     // one of CampaignAgeGroups()
  std::string consent_date;  // YYYY-MM-DD; empty only for virtual people
  bool is_virtual = false;
};

struct StoredPicture {
  std::string name;  // bgHand.png
  std::uint64_t bytes = 0;
  std::string sha256;  // hex
};

// One capture folder, people/ID/sessions/N/HAND/NUMBER.
struct StoredCapture {
  CampaignHand hand = CampaignHand::kLeft;
  int number = 0;                       // from 1
  std::string calibration;              // SHA-256 of calibrations/SHA256.json; empty: none
  std::vector<int> lasers;              // whose pictures are there
  std::vector<StoredPicture> pictures;  // by name
};

struct CaptureKey {
  CampaignHand hand = CampaignHand::kLeft;
  int number = 0;
};

// The manifest of one session: what it does not name does not count.
struct CampaignSession {
  int number = 0;  // from 1
  std::vector<StoredCapture> captures;
  std::optional<CaptureKey> unfinished;  // a folder that is just coming or going; none at rest

  int Count(CampaignHand hand) const;
  const StoredCapture* Find(CampaignHand hand, int capture) const;
};

// A capture of a campaign with its place.
struct CampaignCapture {
  std::string id;
  int session = 0;
  StoredCapture stored;

  std::string Name() const;  // of its folder wherever captures lie side by side: p01_s1_left_k1
  std::filesystem::path Folder(const std::filesystem::path& campaign) const;
};

}  // namespace dorsum
