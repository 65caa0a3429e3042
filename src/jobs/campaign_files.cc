// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_files.h"

#include <utility>

#include "jobs/campaign_json.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCampaignSchema = "dorsum/campaign";
constexpr const char* kPersonSchema = "dorsum/campaign_person";

}  // namespace

Status WriteCampaign(const fs::path& dir, const Campaign& campaign) {
  Json json = StartSealed(kCampaignSchema);
  json["name"] = campaign.name;
  Json hands = Json::array();
  for (const CampaignHand hand : campaign.plan.hands) hands.push_back(HandWord(hand));
  json["plan"] = {{"people", campaign.plan.people},
                  {"sessions", campaign.plan.sessions},
                  {"captures", campaign.plan.captures},
                  {"hands", hands}};
  json["device"] = {{"name", campaign.device.name},
                    {"resolution_px", {campaign.device.width, campaign.device.height}},
                    {"lasers", campaign.device.lasers}};
  json["calibration"] = campaign.calibration;
  if (campaign.virtual_people) {
    json["virtual"] = {{"seed", campaign.virtual_people->seed},
                       {"people", campaign.virtual_people->people},
                       {"device_sha256", campaign.virtual_people->device_sha256}};
  }
  return WriteSealed(dir / kCampaignJson, std::move(json));
}

Result<Campaign> ReadCampaign(const fs::path& dir) {
  const fs::path path = dir / kCampaignJson;
  DORSUM_ASSIGN_OR_RETURN(const Json json, ReadSealed(path));
  JsonReader reader(json, path.string());
  reader.Schema(kCampaignSchema, kCampaignSchemaVersion);
  Campaign c;
  c.name = reader.Text("name");
  c.calibration = HashOrNone(&reader, "calibration");
  JsonReader plan(reader.Object("plan"), path.string() + ", plan");
  JsonReader device(reader.Object("device"), path.string() + ", device");
  DORSUM_RETURN_IF_ERROR(reader.status());
  c.plan.people = plan.Integer("people", 0, kMaxPeople);
  c.plan.sessions = plan.Integer("sessions", 1, kMaxSessions);
  c.plan.captures = plan.Integer("captures", 1, kMaxCaptures);
  c.plan.hands.clear();
  for (const Json& item : plan.Array("hands", 2)) {
    const auto hand = HandOfWord(item.is_string() ? item.get<std::string>() : "");
    if (!hand || (!c.plan.hands.empty() && *hand <= c.plan.hands.back())) {
      plan.Fail("hands", "must be left, right or both");
      break;
    }
    c.plan.hands.push_back(*hand);
  }
  if (c.plan.hands.empty()) plan.Fail("hands", "must not be empty");
  DORSUM_RETURN_IF_ERROR(plan.status());
  c.device.name = device.Text("name");
  const std::vector<double> size = device.Numbers("resolution_px", 2, 0, 1e6);
  c.device.width = static_cast<int>(size[0]);
  c.device.height = static_cast<int>(size[1]);
  c.device.lasers = LasersOf(&device);
  DORSUM_RETURN_IF_ERROR(device.status());
  if (reader.Has("virtual")) {
    JsonReader people(reader.Object("virtual"), path.string() + ", virtual");
    c.virtual_people.emplace();
    c.virtual_people->seed = people.Text("seed");
    c.virtual_people->people = people.Integer("people", 1, kMaxPeople);
    c.virtual_people->device_sha256 = HashOrNone(&people, "device_sha256");
    DORSUM_RETURN_IF_ERROR(people.status());
  }
  DORSUM_RETURN_IF_ERROR(reader.status());
  return c;
}

Status WritePerson(const fs::path& dir, const CampaignPerson& person) {
  Json json = StartSealed(kPersonSchema);
  json["id"] = person.id;
  json["sex"] = person.sex;
  json["age_group"] = person.age_group;
  json["consent_date"] = person.consent_date;
  json["virtual"] = person.is_virtual;
  return WriteSealed(PersonFolder(dir, person.id) / kPersonJson, std::move(json));
}

Result<CampaignPerson> ReadPerson(const fs::path& dir, const std::string& id) {
  const fs::path path = PersonFolder(dir, id) / kPersonJson;
  DORSUM_ASSIGN_OR_RETURN(const Json json, ReadSealed(path));
  JsonReader reader(json, path.string());
  reader.Schema(kPersonSchema, kCampaignSchemaVersion);
  CampaignPerson p;
  p.id = reader.Text("id");
  if (p.id != id) reader.Fail("id", "is not the name of the person's folder");
  p.sex = WordOf(&reader, "sex", CampaignSexes());
  p.age_group = WordOf(&reader, "age_group", CampaignAgeGroups());
  p.consent_date = reader.Text("consent_date");
  p.is_virtual = reader.Bool("virtual");
  if (!p.is_virtual && !CheckConsentDate(p.consent_date, "9999-12-31").ok()) {
    reader.Fail("consent_date", "is no date");
  }
  DORSUM_RETURN_IF_ERROR(reader.status());
  return p;
}

}  // namespace dorsum
