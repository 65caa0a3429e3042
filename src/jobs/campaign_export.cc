// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_export.h"

#include <map>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_export_files.h"
#include "jobs/campaign_export_people.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExportJson = "export.json";

Json PeopleToJson(const std::map<std::string, ExportedPerson>& people) {
  std::map<std::string, Json> by_new_id;  // not in the order in which they came
  for (const auto& [old_id, person] : people) {
    Json entry = {{"id", person.id}};
    if (!person.sex.empty()) entry["sex"] = person.sex;
    if (!person.age_group.empty()) entry["age_group"] = person.age_group;
    by_new_id[person.id] = entry;
  }
  Json list = Json::array();
  for (const auto& [id, entry] : by_new_id) list.push_back(entry);
  return list;
}

struct Exporter {
  const ExportRequest& request;
  const Context& context;
  std::map<std::string, ExportedPerson> people;
  std::map<std::string, std::string> calibrations;  // the exported one's hash by the stored one's
  std::map<std::string, Json> captures;             // by name

  Status WriteCalibration(const std::string& hash, ExportWriter* writer) {
    if (hash.empty() || calibrations.contains(hash)) return {};
    DORSUM_ASSIGN_OR_RETURN(const std::string text, PlainCalibration(CalibrationFile(request.dir, hash)));
    calibrations[hash] = Sha256Hex(text);
    return writer->Write(std::string(kCalibrationsFolder) + "/" + calibrations[hash] + ".json", text);
  }

  Status WriteCapture(const CampaignCapture& capture, ExportWriter* writer) {
    DORSUM_RETURN_IF_ERROR(WriteCalibration(capture.stored.calibration, writer));
    CampaignCapture renamed = capture;
    renamed.id = people.at(capture.id).id;
    const std::string name = renamed.Name();
    for (const StoredPicture& p : capture.stored.pictures) {
      DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
      const fs::path path = capture.Folder(request.dir) / p.name;
      DORSUM_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path));
      if (Sha256Hex(bytes) != p.sha256)
        return BadInput(path.string() + " was changed since it was stored; restore it from a copy");
      DORSUM_ASSIGN_OR_RETURN(const std::string plain, PlainPicture(bytes, path.string()));
      DORSUM_RETURN_IF_ERROR(writer->Write("captures/" + name + "/" + p.name, plain));
    }
    captures[name] = {
        {"name", name},
        {"person", renamed.id},
        {"session", capture.session},
        {"hand", HandWord(capture.stored.hand)},
        {"capture", capture.stored.number},
        {"calibration",
         capture.stored.calibration.empty() ? std::string() : calibrations.at(capture.stored.calibration)}};
    return {};
  }
};

Result<std::vector<CampaignPerson>> ReadPeople(const fs::path& dir,
                                               const std::vector<CampaignCapture>& captures) {
  std::set<std::string> ids;  // who gave nothing has nothing to be exported
  for (const CampaignCapture& c : captures) ids.insert(c.id);
  std::vector<CampaignPerson> people;
  for (const std::string& id : ids) {
    DORSUM_ASSIGN_OR_RETURN(CampaignPerson person, ReadPerson(dir, id));
    people.push_back(std::move(person));
  }
  return people;
}

}  // namespace

Result<ExportSummary> ExportCampaign(const ExportRequest& request, const Context& context) {
  if (request.least < 2 || request.least > 1000)
    return UsageError("the least size of a group is 2 to 1000 people");
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(request.dir, CampaignLock::Kind::kReader, context));
  DORSUM_ASSIGN_OR_RETURN(const Campaign campaign, ReadCampaign(request.dir));
  DORSUM_ASSIGN_OR_RETURN(const std::vector<CampaignCapture> captures, ListCaptures(request.dir));
  if (captures.empty()) return BadInput(request.dir.string() + " has no captures to export");
  DORSUM_ASSIGN_OR_RETURN(const std::vector<CampaignPerson> people, ReadPeople(request.dir, captures));
  std::error_code ec;
  if (fs::exists(request.out_dir, ec) &&
      (!fs::is_directory(request.out_dir, ec) || !fs::is_empty(request.out_dir, ec))) {
    return BadInput(request.out_dir.string() + " is not an empty folder; choose another one");
  }
  const fs::path inside =
      fs::weakly_canonical(request.out_dir, ec).lexically_relative(fs::weakly_canonical(request.dir, ec));
  if (!inside.empty() && *inside.begin() != "..") {
    return BadInput(request.out_dir.string() + " lies in the campaign; choose a folder outside");
  }
  ExportSummary summary;
  Exporter exporter{request, context, DrawExportIds(people), {}, {}};
  if (request.groups) {
    summary.attributes = TellGroups(people, request.least, &exporter.people);
    if (summary.attributes.size() < 2) {
      summary.warnings.push_back(
          "not all of sex and age group is told, since some group would have fewer than " +
          std::to_string(request.least) + " people");
    }
  }
  DORSUM_ASSIGN_OR_RETURN(StagedFolder staged, StagedFolder::Create(request.out_dir));
  ExportWriter writer(staged.path());
  for (const CampaignCapture& c : captures) {
    context.Report("exporting", static_cast<double>(summary.captures) / static_cast<double>(captures.size()));
    DORSUM_RETURN_IF_ERROR(exporter.WriteCapture(c, &writer));
    ++summary.captures;
  }
  summary.people = static_cast<int>(people.size());
  Json list = Json::array();
  for (const auto& [name, entry] : exporter.captures) list.push_back(entry);
  const Json json = {{"schema", "dorsum/campaign_export"},
                     {"version", 1},
                     {"virtual", campaign.virtual_people.has_value()},
                     {"people", PeopleToJson(exporter.people)},
                     {"captures", list}};
  DORSUM_RETURN_IF_ERROR(writer.Write(kExportJson, json.dump(1) + "\n"));
  DORSUM_RETURN_IF_ERROR(writer.Finish());
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  fs::remove(request.out_dir, ec);  // an empty folder makes room, so that all comes with one rename
  DORSUM_RETURN_IF_ERROR(staged.Commit());
  return summary;
}

}  // namespace dorsum
