// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_verify.h"

#include <optional>
#include <set>

#include "base/files.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class Verifier {
 public:
  Verifier(const fs::path& dir, const Context& context) : dir_(dir), context_(context) {}

  Result<CampaignVerification> Run() {
    Know(dir_ / kCampaignJson);
    Know(dir_ / kCampaignLock);
    Know(dir_ / kPeopleFolder);
    Know(dir_ / kCalibrationsFolder);
    const auto campaign = ReadCampaign(dir_);
    if (!campaign.ok()) Find(campaign.error().message);
    if (campaign.ok()) plan_ = campaign->plan;
    DORSUM_RETURN_IF_ERROR(CheckPeople(campaign.ok() ? &*campaign : nullptr));
    DORSUM_RETURN_IF_ERROR(CheckFiles());
    if (campaign.ok() && !campaign->calibration.empty()) calibrations_.insert(campaign->calibration);
    DORSUM_RETURN_IF_ERROR(CheckCalibrations());
    CheckTree(dir_);
    return out_;
  }

 private:
  void Find(const std::string& sentence) { out_.findings.push_back(sentence); }
  void Know(const fs::path& path) { known_.insert(path.string()); }

  Status CheckPeople(const Campaign* campaign) {
    const auto people = ListPeople(dir_);
    if (!people.ok()) {
      Find(people.error().message);
      return {};
    }
    for (const std::string& id : *people) {
      DORSUM_RETURN_IF_ERROR(context_.CheckCancelled());
      const fs::path folder = PersonFolder(dir_, id);
      ++out_.people;
      for (const fs::path& path : {folder, folder / kPersonJson, folder / kSessionsFolder}) Know(path);
      const auto person = ReadPerson(dir_, id);
      if (!person.ok()) {
        Find(person.error().message);
      } else if (campaign != nullptr && person->is_virtual != campaign->virtual_people.has_value()) {
        Find(folder.string() + " is a " + (person->is_virtual ? "virtual" : "real") +
             " person in a campaign of the other kind");
      }
      CheckSessions(id);
    }
    return {};
  }

  void CheckSessions(const std::string& id) {
    const auto sessions = ListSessions(dir_, id);
    if (!sessions.ok()) return Find(sessions.error().message);
    for (const int n : *sessions) {
      const fs::path folder = SessionFolder(dir_, id, n);
      Know(folder);
      Know(folder / kSessionManifest);
      const auto session = ReadSession(dir_, id, n);
      if (!session.ok()) {
        Find(session.error().message + "; what else lies in its folder cannot be checked");
        closed_.insert(folder.string());
        continue;
      }
      if (session->unfinished) {
        const fs::path left = CaptureFolder(dir_, id, n, *session->unfinished);
        Find(left.string() +
             " was being added or removed when the command was killed; the next command that writes clears "
             "it");
        closed_.insert(left.string());
        Know(left);
        Know(left.parent_path());
      }
      if (plan_ && n > plan_->sessions) Find(folder.string() + " is a session beyond the plan");
      for (const StoredCapture& c : session->captures) Queue({id, n, c});
    }
  }

  void Queue(CampaignCapture capture) {
    const fs::path folder = capture.Folder(dir_);
    Know(folder.parent_path());
    Know(folder);
    for (const StoredPicture& p : capture.stored.pictures) Know(folder / p.name);
    if (!capture.stored.calibration.empty()) calibrations_.insert(capture.stored.calibration);
    if (plan_ && capture.stored.number > plan_->captures)
      Find(folder.string() + " is a capture beyond the plan");
    captures_.push_back(std::move(capture));
  }

  Status CheckFiles() {
    for (const CampaignCapture& c : captures_) {
      context_.Report("checking " + c.Name(),
                      static_cast<double>(out_.captures) / static_cast<double>(captures_.size()));
      ++out_.captures;
      for (const StoredPicture& p : c.stored.pictures) {
        DORSUM_RETURN_IF_ERROR(context_.CheckCancelled());
        CheckFile(c.Folder(dir_) / p.name, p.bytes, p.sha256);
      }
    }
    return {};
  }

  void CheckFile(const fs::path& path, std::uint64_t bytes, const std::string& sha256) {
    std::error_code ec;
    if (!fs::exists(fs::symlink_status(path, ec)))
      return Find(path.string() + " is missing; restore it from a copy");
    const Result<std::string> content = ReadFile(path);
    if (!content.ok()) return Find(content.error().message);
    ++out_.files;
    out_.bytes += content->size();
    if (bytes > 0 && content->size() != bytes) {
      Find(path.string() + " has " + std::to_string(content->size()) + " bytes, but " +
           std::to_string(bytes) + " were stored; restore it from a copy");
    } else if (Sha256Hex(*content) != sha256) {
      Find(path.string() + " was changed since it was stored; restore it from a copy");
    }
  }

  Status CheckCalibrations() {
    std::error_code ec;
    if (fs::is_directory(dir_ / kCalibrationsFolder, ec)) {
      DORSUM_ASSIGN_OR_RETURN(const auto names, NamesIn(dir_ / kCalibrationsFolder));
      for (const std::string& name : names) {  // one that no capture needs does no harm
        const std::string hash = fs::path(name).stem().string();
        if (IsSha256(hash) && name == hash + ".json") calibrations_.insert(hash);
      }
    }
    for (const std::string& hash : calibrations_) {
      DORSUM_RETURN_IF_ERROR(context_.CheckCancelled());
      Know(CalibrationFile(dir_, hash));
      CheckFile(CalibrationFile(dir_, hash), 0, hash);
    }
    return {};
  }

  // Everything below that nobody has named.
  void CheckTree(const fs::path& folder) {
    const auto names = NamesIn(folder);
    if (!names.ok()) return Find(names.error().message);
    for (const std::string& name : *names) CheckEntry(folder / name, name);
  }

  void CheckEntry(const fs::path& path, const std::string& name) {
    std::error_code ec;
    const fs::file_status status = fs::symlink_status(path, ec);
    const std::string text = path.string();
    if (fs::is_symlink(status)) return Find(text + " is a link; a campaign holds its files itself");
    if (known_.contains(text)) {
      if (fs::is_directory(status) && !closed_.contains(text)) CheckTree(path);
      return;
    }
    if (name.rfind(kWorkPrefix, 0) == 0 && fs::is_directory(status)) {
      if (WorkFolder::IsDead(path))
        Find(text + " was left by a command that was killed; the next command that writes clears it");
      return;
    }
    if (name.rfind(kRemovePrefix, 0) == 0) {
      return Find(text +
                  " holds what is left of a person whose removal was interrupted; run the removal again");
    }
    Find(text + " does not belong to the campaign; move it away");
  }

  const fs::path& dir_;
  const Context& context_;
  CampaignVerification out_;
  std::optional<CampaignPlan> plan_;
  std::vector<CampaignCapture> captures_;
  std::set<std::string> known_;         // paths that belong here
  std::set<std::string> closed_;        // of them, folders about which enough was said
  std::set<std::string> calibrations_;  // that are there or should be
};

}  // namespace

Result<CampaignVerification> VerifyCampaign(const fs::path& dir, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(dir, CampaignLock::Kind::kReader, context));
  // Without a slash at the end, so that each path is spelt in one way.
  fs::path clean = dir.lexically_normal();
  if (!clean.has_filename()) clean = clean.parent_path();
  return Verifier(clean, context).Run();
}

Json VerificationToJson(const CampaignVerification& v) {
  return {{"intact", v.findings.empty()},
          {"people", v.people},
          {"captures", v.captures},
          {"files", v.files},
          {"bytes", v.bytes},
          {"findings", v.findings}};
}

std::string VerificationToText(const CampaignVerification& v) {
  std::string text;
  for (const std::string& finding : v.findings) text += finding + "\n";
  text += std::to_string(v.people) + " people, " + std::to_string(v.captures) + " captures, " +
          std::to_string(v.files) + " files, " + std::to_string(v.bytes) + " bytes: ";
  return text + (v.findings.empty() ? "all as stored" : std::to_string(v.findings.size()) + " findings") +
         "\n";
}

}  // namespace dorsum
