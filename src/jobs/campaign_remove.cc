// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_remove.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>

#include <unistd.h>  // mkdtemp

#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_recovery.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

Status RemoveAll(const fs::path& path) {
  std::error_code ec;
  fs::remove_all(path, ec);
  if (ec) return BadInput("cannot remove " + path.string() + ": " + ec.message());
  return SyncToDisk(path.parent_path());
}

// Calibrations that no capture needs any more. While a manifest cannot be read, none is known to be one.
Status RemoveUnusedCalibrations(const fs::path& dir) {
  std::error_code ec;
  const auto campaign = ReadCampaign(dir);
  const auto captures = ListCaptures(dir);
  if (!campaign.ok() || !captures.ok() || !fs::is_directory(dir / kCalibrationsFolder, ec)) return {};
  std::set<std::string> used = {campaign->calibration};
  for (const CampaignCapture& c : *captures) used.insert(c.stored.calibration);
  DORSUM_ASSIGN_OR_RETURN(const auto names, NamesIn(dir / kCalibrationsFolder));
  for (const std::string& name : names) {
    const std::string hash = fs::path(name).stem().string();
    if (!IsSha256(hash) || name != hash + ".json" || used.contains(hash)) continue;
    DORSUM_RETURN_IF_ERROR(RemoveAll(dir / kCalibrationsFolder / name));
  }
  return {};
}

Status RemovePerson(const fs::path& dir, const std::string& id) {
  // The new name holds no id, and from here on the person is in no list.
  std::string aside = (dir / (std::string(kRemovePrefix) + "XXXXXX")).string();
  if (mkdtemp(aside.data()) == nullptr)
    return BadInput("cannot write to " + dir.string() + ": " + std::strerror(errno));
  std::error_code ec;
  fs::rename(PersonFolder(dir, id), fs::path(aside) / "person", ec);
  if (ec) {
    const std::string why = ec.message();
    fs::remove(aside, ec);
    return BadInput("cannot remove " + PersonFolder(dir, id).string() + ": " + why);
  }
  DORSUM_RETURN_IF_ERROR(SyncToDisk(dir / kPeopleFolder));
  return RemoveAll(aside);
}

Status RemoveCapture(const RemoveRequest& request) {
  const CaptureKey key = *request.capture;
  DORSUM_ASSIGN_OR_RETURN(CampaignSession session, ReadSession(request.dir, request.id, request.session));
  if (session.Find(key.hand, key.number) == nullptr) {
    return BadInput("there is no " + std::string(HandWord(key.hand)) + " capture " +
                    std::to_string(key.number) + " in session " + std::to_string(request.session) + " of " +
                    request.id);
  }
  std::erase_if(session.captures,
                [&](const StoredCapture& c) { return c.hand == key.hand && c.number == key.number; });
  session.unfinished = key;
  DORSUM_RETURN_IF_ERROR(WriteSession(request.dir, request.id, session));
  const fs::path folder = CaptureFolder(request.dir, request.id, request.session, key);
  DORSUM_RETURN_IF_ERROR(RemoveAll(folder));
  std::error_code ignored;
  fs::remove(folder.parent_path(), ignored);  // if it was the hand's last
  session.unfinished.reset();
  return WriteSession(request.dir, request.id, session);
}

}  // namespace

Result<RemoveSummary> RemoveFromCampaign(const RemoveRequest& request, const Context& context) {
  DORSUM_RETURN_IF_ERROR(CheckPersonId(request.id));
  const fs::path& dir = request.dir;
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(dir, CampaignLock::Kind::kWriter, context));
  DORSUM_ASSIGN_OR_RETURN(const Recovered recovered, RecoverCampaign(dir, lock));
  DORSUM_ASSIGN_OR_RETURN(const auto people, ListPeople(dir));
  RemoveSummary summary;
  if (std::find(people.begin(), people.end(), request.id) == people.end()) {
    if (recovered.removals == 0 || request.capture)
      return BadInput("there is no person " + request.id + " in " + dir.string());
    summary.finished = true;
    DORSUM_RETURN_IF_ERROR(RemoveUnusedCalibrations(dir));
    return summary;
  }
  if (request.capture) {
    DORSUM_RETURN_IF_ERROR(RemoveCapture(request));
    summary.captures = 1;
  } else {
    std::vector<std::string> problems;  // a damaged manifest must not keep anyone from being deleted
    DORSUM_ASSIGN_OR_RETURN(const auto captures, ListCaptures(dir, &problems));
    summary.captures = static_cast<int>(std::count_if(
        captures.begin(), captures.end(), [&](const CampaignCapture& c) { return c.id == request.id; }));
    DORSUM_RETURN_IF_ERROR(RemovePerson(dir, request.id));
  }
  DORSUM_RETURN_IF_ERROR(RemoveUnusedCalibrations(dir));
  return summary;
}

}  // namespace dorsum
