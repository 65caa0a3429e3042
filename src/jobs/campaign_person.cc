// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "jobs/campaign_add.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_recovery.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// Ids that differ only in case would be one folder on some disks, and one person to most readers.
std::string LowerCase(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

Status CheckWord(const std::string& what, const std::string& word, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), word) != words.end()) return {};
  std::string list;
  for (const std::string& w : words) list += (list.empty() ? "" : ", ") + w;
  return UsageError("the " + what + " must be one of " + list);
}

Status CheckPerson(const AddPersonRequest& request) {
  const CampaignPerson& p = request.person;
  DORSUM_RETURN_IF_ERROR(CheckPersonId(p.id));
  DORSUM_RETURN_IF_ERROR(CheckWord("sex", p.sex, CampaignSexes()));
  DORSUM_RETURN_IF_ERROR(CheckWord("age group", p.age_group, CampaignAgeGroups()));
  if (!p.is_virtual) {
    return CheckConsentDate(p.consent_date, request.today.empty() ? Today() : request.today);
  }
  return p.consent_date.empty() ? Status() : Status(UsageError("a virtual person gives no consent"));
}

}  // namespace

Status AddPerson(const AddPersonRequest& request, const Context& context) {
  DORSUM_RETURN_IF_ERROR(CheckPerson(request));
  const fs::path& dir = request.dir;
  const CampaignPerson& person = request.person;
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(dir, CampaignLock::Kind::kWriter, context));
  DORSUM_RETURN_IF_ERROR(RecoverCampaign(dir, lock));
  DORSUM_ASSIGN_OR_RETURN(const Campaign campaign, ReadCampaign(dir));
  if (campaign.virtual_people.has_value() != person.is_virtual) {
    return BadInput(campaign.virtual_people
                        ? dir.string() + " is a campaign of virtual people; make another for real ones"
                        : dir.string() + " is a campaign of real people; virtual ones have their own");
  }
  DORSUM_ASSIGN_OR_RETURN(const std::vector<std::string> people, ListPeople(dir));
  const auto same = std::find_if(people.begin(), people.end(), [&](const std::string& id) {
    return LowerCase(id) == LowerCase(person.id);
  });
  if (request.correct) {
    if (same == people.end() || *same != person.id)
      return BadInput("there is no person " + person.id + " in " + dir.string() + " to correct");
    return WritePerson(dir, person);
  }
  if (same != people.end()) {
    return BadInput("there is a person " + *same + " in " + dir.string() + " already; choose another id");
  }
  const fs::path folder = PersonFolder(dir, person.id);
  DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(folder));
  Status written = WritePerson(dir, person);
  std::error_code ignored;
  if (!written.ok()) fs::remove(folder, ignored);
  return written;
}

}  // namespace dorsum
