// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jobs/campaign.h"

namespace dorsum {

// A person as others get to know them.
struct ExportedPerson {
  std::string id;              // new and random
  std::string sex, age_group;  // empty: not told
};

// Fresh random ids, "x" and ten hex digits, none of which is anybody's old one. By the old id.
std::map<std::string, ExportedPerson> DrawExportIds(const std::vector<CampaignPerson>& people);

// under-40, 40-59, over-59 or not-said.
std::string CoarseAgeGroup(const std::string& age_group);

// Tells sex and coarse age group, if each combination that occurs is shared by `least` people or more; if
// not, sex alone or age group alone under the same rule, or nothing. It is all or nothing for an attribute,
// since telling it of some would tell it of the rest. Gives the attributes that are told.
std::vector<std::string> TellGroups(const std::vector<CampaignPerson>& people, int least,
                                    std::map<std::string, ExportedPerson>* exported);

}  // namespace dorsum
