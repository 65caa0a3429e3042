// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_status.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_quality.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

using HandKey = std::tuple<std::string, int, CampaignHand>;  // id, session, hand

void CountCaptures(const std::vector<CampaignCapture>& captures, CampaignStatus* status) {
  std::set<std::pair<std::string, int>> sessions;
  std::set<std::pair<std::string, CampaignHand>> hands;
  std::set<std::string> calibrations;
  for (const CampaignCapture& c : captures) {
    sessions.emplace(c.id, c.session);
    hands.emplace(c.id, c.stored.hand);
    if (c.stored.calibration.empty()) ++status->without_calibration;
    if (!c.stored.calibration.empty()) calibrations.insert(c.stored.calibration);
    if (c.stored.lasers.size() < status->campaign.device.lasers.size()) ++status->lacking_laser;
    for (const StoredPicture& p : c.stored.pictures) status->bytes += p.bytes;
  }
  status->captures = static_cast<int>(captures.size());
  status->sessions = static_cast<int>(sessions.size());
  status->hands = static_cast<int>(hands.size());
  status->calibrations = static_cast<int>(calibrations.size());
}

// Of people who are there; those who have not come yet are counted, not listed.
void FindMissing(const std::vector<std::string>& people, const std::vector<CampaignCapture>& captures,
                 CampaignStatus* status) {
  const CampaignPlan& plan = status->campaign.plan;
  std::map<HandKey, int> taken;
  for (const CampaignCapture& c : captures) ++taken[{c.id, c.session, c.stored.hand}];
  for (const std::string& id : people) {
    const std::size_t before = status->missing.size();
    for (int session = 1; session <= plan.sessions; ++session) {
      for (const CampaignHand hand : plan.hands) {
        const auto it = taken.find({id, session, hand});
        const int count = plan.captures - (it == taken.end() ? 0 : it->second);
        if (count > 0) status->missing.push_back({id, session, hand, count});
      }
    }
    if (status->missing.size() == before) ++status->complete;
  }
  const int wanted = std::max(plan.people, static_cast<int>(people.size()));
  status->planned_captures = wanted * plan.sessions * plan.captures * static_cast<int>(plan.hands.size());
}

}  // namespace

Result<CampaignStatus> StatusOfCampaign(const fs::path& dir, const fs::path& surfaces,
                                        const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(dir, CampaignLock::Kind::kReader, context));
  CampaignStatus status;
  DORSUM_ASSIGN_OR_RETURN(status.campaign, ReadCampaign(dir));
  DORSUM_ASSIGN_OR_RETURN(std::vector<std::string> people, ListPeople(dir));
  std::erase_if(people, [&](const std::string& id) {
    const auto person = ReadPerson(dir, id);
    if (!person.ok()) {
      status.problems.push_back(person.error().message);
      return true;
    }
    ++status.sexes[person->sex];
    ++status.age_groups[person->age_group];
    return false;
  });
  status.people = static_cast<int>(people.size());
  DORSUM_ASSIGN_OR_RETURN(std::vector<CampaignCapture> captures, ListCaptures(dir, &status.problems));
  std::erase_if(captures, [&](const CampaignCapture& c) {
    return !std::binary_search(people.begin(), people.end(), c.id);
  });
  CountCaptures(captures, &status);
  FindMissing(people, captures, &status);
  if (!surfaces.empty()) {
    DORSUM_ASSIGN_OR_RETURN(status.quality, ReadQuality(surfaces, captures));
  }
  return status;
}

}  // namespace dorsum
