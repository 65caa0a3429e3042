// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_export_people.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>

namespace dorsum {
namespace {

std::string RandomId(std::random_device* random) {
  std::string id = "x";
  for (int i = 0; i < 10; ++i) id += "0123456789abcdef"[(*random)() % 16];
  return id;
}

// Whether each value of `key` that occurs is shared by `least` people.
template <class Key>
bool SharedByAll(const std::vector<CampaignPerson>& people, int least, const Key& key) {
  std::map<decltype(key(people.front())), int> counts;
  for (const CampaignPerson& p : people) ++counts[key(p)];
  return !people.empty() &&
         std::all_of(counts.begin(), counts.end(), [&](const auto& entry) { return entry.second >= least; });
}

}  // namespace

std::map<std::string, ExportedPerson> DrawExportIds(const std::vector<CampaignPerson>& people) {
  std::random_device random;  // the operating system's: nothing that could be drawn again
  std::set<std::string> taken;
  for (const CampaignPerson& p : people) taken.insert(p.id);
  std::map<std::string, ExportedPerson> out;
  for (const CampaignPerson& p : people) {
    std::string id = RandomId(&random);
    while (!taken.insert(id).second) id = RandomId(&random);
    out[p.id].id = id;
  }
  return out;
}

std::string CoarseAgeGroup(const std::string& age_group) {
  if (age_group == "not-said") return age_group;
  if (age_group == "under-20" || age_group == "20-29" || age_group == "30-39") return "under-40";
  return age_group == "40-49" || age_group == "50-59" ? "40-59" : "over-59";
}

std::vector<std::string> TellGroups(const std::vector<CampaignPerson>& people, int least,
                                    std::map<std::string, ExportedPerson>* exported) {
  const auto sex = [](const CampaignPerson& p) { return p.sex; };
  const auto age = [](const CampaignPerson& p) { return CoarseAgeGroup(p.age_group); };
  const bool both =
      SharedByAll(people, least, [&](const CampaignPerson& p) { return std::pair(sex(p), age(p)); });
  const bool tell_sex = both || SharedByAll(people, least, sex);
  const bool tell_age = both || (!tell_sex && SharedByAll(people, least, age));
  for (const CampaignPerson& p : people) {
    ExportedPerson& e = exported->at(p.id);
    if (tell_sex) e.sex = sex(p);
    if (tell_age) e.age_group = age(p);
  }
  std::vector<std::string> told;
  if (tell_sex) told.emplace_back("sex");
  if (tell_age) told.emplace_back("age_group");
  return told;
}

}  // namespace dorsum
