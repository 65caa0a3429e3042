// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_recovery.h"

#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

Status Remove(const fs::path& path) {
  std::error_code ec;
  fs::remove_all(path, ec);
  if (ec) return BadInput("cannot remove " + path.string() + ": " + ec.message());
  return {};
}

// Work folders of commands that no longer run. Several may have been filled by one: each is counted.
Status ClearWork(const fs::path& folder, int* cleared) {
  DORSUM_ASSIGN_OR_RETURN(const auto names, NamesIn(folder));
  for (const std::string& name : names) {
    if (name.rfind(kWorkPrefix, 0) != 0 || !WorkFolder::IsDead(folder / name)) continue;
    DORSUM_RETURN_IF_ERROR(Remove(folder / name));
    ++*cleared;
  }
  return {};
}

Status RecoverSession(const fs::path& dir, const std::string& id, int number, Recovered* recovered) {
  const fs::path folder = SessionFolder(dir, id, number);
  DORSUM_RETURN_IF_ERROR(Remove(AsideOf(folder / kSessionManifest)));
  std::error_code ignored;
  if (fs::remove(folder, ignored)) return {};  // it was empty: killed before its manifest
  Result<CampaignSession> session = ReadSession(dir, id, number);
  if (!session.ok() || !session->unfinished) return {};
  if (session->Find(session->unfinished->hand, session->unfinished->number) == nullptr) {
    const fs::path capture = CaptureFolder(dir, id, number, *session->unfinished);
    DORSUM_RETURN_IF_ERROR(Remove(capture));
    fs::remove(capture.parent_path(), ignored);  // if empty
    ++recovered->captures;
  }
  session->unfinished.reset();
  return WriteSession(dir, id, *session);
}

Status RecoverPerson(const fs::path& dir, const std::string& id, Recovered* recovered) {
  const fs::path folder = PersonFolder(dir, id);
  std::error_code ec;
  DORSUM_RETURN_IF_ERROR(ClearWork(folder, &recovered->captures));
  DORSUM_RETURN_IF_ERROR(Remove(AsideOf(folder / kPersonJson)));
  if (fs::remove(folder, ec)) return {};  // it was empty: killed before its person.json
  DORSUM_ASSIGN_OR_RETURN(const auto sessions, ListSessions(dir, id));
  for (const int n : sessions) DORSUM_RETURN_IF_ERROR(RecoverSession(dir, id, n, recovered));
  return {};
}

}  // namespace

Result<Recovered> RecoverCampaign(const fs::path& dir, const CampaignLock& /*lock*/) {
  Recovered recovered;
  int work = 0;
  DORSUM_ASSIGN_OR_RETURN(const auto names, NamesIn(dir));
  for (const std::string& name : names) {
    if (name.rfind(kRemovePrefix, 0) != 0) continue;
    DORSUM_RETURN_IF_ERROR(Remove(dir / name));
    ++recovered.removals;
  }
  DORSUM_RETURN_IF_ERROR(ClearWork(dir, &work));
  DORSUM_RETURN_IF_ERROR(Remove(AsideOf(dir / kCampaignJson)));
  std::error_code ec;
  if (fs::is_directory(dir / kCalibrationsFolder, ec)) {
    DORSUM_ASSIGN_OR_RETURN(const auto calibrations, NamesIn(dir / kCalibrationsFolder));
    for (const std::string& name : calibrations) {
      if (name.size() == 75 && name.front() == '.' && IsSha256(name.substr(1, 64)))  // AsideOf one
        DORSUM_RETURN_IF_ERROR(Remove(dir / kCalibrationsFolder / name));
    }
  }
  if (!fs::is_directory(dir / kPeopleFolder, ec)) return recovered;
  DORSUM_ASSIGN_OR_RETURN(const auto people, ListPeople(dir));
  for (const std::string& id : people) DORSUM_RETURN_IF_ERROR(RecoverPerson(dir, id, &recovered));
  return recovered;
}

}  // namespace dorsum
