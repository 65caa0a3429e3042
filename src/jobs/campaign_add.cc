// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_add.h"

#include <algorithm>

#include "jobs/campaign_create.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_pictures.h"
#include "jobs/campaign_recovery.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

struct Place {
  CampaignSession session;  // as it is now; new ones have no captures
  bool is_new = false;
  int number = 0;
};

Status CheckPersonThere(const AddCaptureRequest& request) {
  DORSUM_RETURN_IF_ERROR(CheckPersonId(request.id));
  std::error_code ec;
  if (fs::exists(PersonFolder(request.dir, request.id) / kPersonJson, ec)) {
    const Result<CampaignPerson> person = ReadPerson(request.dir, request.id);
    return person.ok() ? Status() : Status(person.error());
  }
  return BadInput("there is no person " + request.id + " in " + request.dir.string() +
                  "; add the person first, with the date of the consent");
}

// The session and the number that the next capture of this hand gets.
Result<Place> FindPlace(const AddCaptureRequest& request, const CampaignPlan& plan) {
  if (std::find(plan.hands.begin(), plan.hands.end(), request.hand) == plan.hands.end())
    return BadInput(std::string("the campaign's plan has no ") + HandWord(request.hand) + " hands");
  DORSUM_ASSIGN_OR_RETURN(const std::vector<int> sessions, ListSessions(request.dir, request.id));
  Place place;
  const int n = request.session.value_or(sessions.empty() ? 1 : sessions.back());
  if (n < 1 || n > plan.sessions) {
    return UsageError("the campaign's plan has sessions 1 to " + std::to_string(plan.sessions) + ", not " +
                      std::to_string(n));
  }
  place.is_new = std::find(sessions.begin(), sessions.end(), n) == sessions.end();
  place.session.number = n;
  if (!place.is_new) {
    DORSUM_ASSIGN_OR_RETURN(place.session, ReadSession(request.dir, request.id, n));
  }
  for (place.number = 1; place.session.Find(request.hand, place.number) != nullptr;) ++place.number;
  if (place.number > plan.captures) {
    return BadInput(std::string("the ") + HandWord(request.hand) + " hand of " + request.id + " has all " +
                    std::to_string(plan.captures) + " captures of session " + std::to_string(n) +
                    (n < plan.sessions ? "; name the next session with --session" : " already"));
  }
  std::error_code ec;
  const fs::path folder = CaptureFolder(request.dir, request.id, n, {request.hand, place.number});
  if (fs::exists(folder, ec)) {
    return BadInput(folder.string() + " is there, but no manifest names it; move it away");
  }
  return place;
}

// The same pictures twice are a slip of the hand: the second time they are most likely someone else's.
Status CheckNotThere(const fs::path& dir, const GatheredPictures& gathered, const std::string& source) {
  DORSUM_ASSIGN_OR_RETURN(const std::vector<CampaignCapture> captures, ListCaptures(dir));
  for (const CampaignCapture& c : captures) {
    for (const StoredPicture& old : c.stored.pictures) {
      for (const StoredPicture& p : gathered.pictures) {
        if (p.sha256 != old.sha256) continue;
        return BadInput(p.name + " of " + source + " is in the campaign already, in " +
                        c.Folder(dir).string() + "; add each capture once");
      }
    }
  }
  return {};
}

// From here to the manifest's second writing, a kill leaves what RecoverCampaign clears.
Status Commit(const AddCaptureRequest& request, const fs::path& pictures, StoredCapture stored,
              Place* place) {
  const CaptureKey key{stored.hand, stored.number};
  const fs::path target = CaptureFolder(request.dir, request.id, place->session.number, key);
  if (place->is_new)
    DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(SessionFolder(request.dir, request.id, place->session.number)));
  place->session.unfinished = key;
  DORSUM_RETURN_IF_ERROR(WriteSession(request.dir, request.id, place->session));
  DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(target.parent_path()));
  std::error_code ec;
  fs::rename(pictures, target, ec);
  if (ec) return BadInput("cannot write " + target.string() + ": " + ec.message());
  DORSUM_RETURN_IF_ERROR(SyncToDisk(target.parent_path()));
  place->session.unfinished.reset();
  place->session.captures.push_back(std::move(stored));
  return WriteSession(request.dir, request.id, place->session);
}

// Of one device, as the campaign knows it and the new calibration says.
struct Setting {
  Campaign campaign;
  std::string calibration;  // the new one's text, or empty
};

Result<Setting> ReadSetting(const AddCaptureRequest& request) {
  Setting setting;
  DORSUM_ASSIGN_OR_RETURN(setting.campaign, ReadCampaign(request.dir));
  if (request.calibration.empty()) return setting;
  DORSUM_ASSIGN_OR_RETURN(setting.calibration,
                          ReadCampaignCalibration(request.calibration, &setting.campaign.device));
  return setting;
}

struct Begun {
  WorkFolder work;
  CampaignDevice device;
};

// Refuses what can be known beforehand, and makes the folder in which the capture grows.
Result<Begun> Begin(const AddCaptureRequest& request, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(request.dir, CampaignLock::Kind::kWriter, context));
  DORSUM_RETURN_IF_ERROR(RecoverCampaign(request.dir, lock));
  DORSUM_ASSIGN_OR_RETURN(const Setting setting, ReadSetting(request));
  DORSUM_RETURN_IF_ERROR(CheckPersonThere(request));
  DORSUM_RETURN_IF_ERROR(FindPlace(request, setting.campaign.plan));
  DORSUM_ASSIGN_OR_RETURN(WorkFolder work, WorkFolder::Create(PersonFolder(request.dir, request.id)));
  return Begun{std::move(work), setting.campaign.device};
}

bool SameDevice(const CampaignDevice& a, const CampaignDevice& b) {
  return a.width == b.width && a.height == b.height && a.lasers == b.lasers;
}

// Somebody may have deleted the person while the capture was made; nothing of it may stay then.
Status CheckStillWanted(const AddCaptureRequest& request) {
  std::error_code ec;
  const fs::path folder = PersonFolder(request.dir, request.id);
  if (fs::exists(folder / kPersonJson, ec)) return {};
  fs::remove_all(folder, ec);
  return BadInput("the person " + request.id + " was removed meanwhile; nothing was stored");
}

}  // namespace

Result<AddedCapture> AddCapture(const AddCaptureRequest& request, const CaptureMaker& maker,
                                const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const Begun begun, Begin(request, context));
  const fs::path pictures = begun.work.path() / "pictures";
  const Status made = maker(pictures, context);
  DORSUM_RETURN_IF_ERROR(CheckStillWanted(request));  // rather than that a folder is missing
  if (!made.ok()) return made.error();
  DORSUM_ASSIGN_OR_RETURN(GatheredPictures gathered, GatherPictures(pictures, begun.device, request.source));
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(request.dir, CampaignLock::Kind::kWriter, context));
  DORSUM_RETURN_IF_ERROR(CheckStillWanted(request));
  DORSUM_ASSIGN_OR_RETURN(Setting setting, ReadSetting(request));
  Campaign& campaign = setting.campaign;
  DORSUM_ASSIGN_OR_RETURN(Place place, FindPlace(request, campaign.plan));
  if (!SameDevice(campaign.device, begun.device)) {  // another command told meanwhile what it is
    DORSUM_ASSIGN_OR_RETURN(gathered, GatherPictures(pictures, campaign.device, request.source));
  }
  DORSUM_RETURN_IF_ERROR(CheckNotThere(request.dir, gathered, request.source));
  const bool news = !SameDevice(campaign.device, gathered.device);
  campaign.device = gathered.device;
  if (!setting.calibration.empty()) {
    DORSUM_RETURN_IF_ERROR(StoreCalibration(request.dir, setting.calibration, &campaign, lock));
  } else if (news) {
    DORSUM_RETURN_IF_ERROR(WriteCampaign(request.dir, campaign));
  }
  StoredCapture stored{request.hand, place.number, campaign.calibration, gathered.lasers, gathered.pictures};
  AddedCapture added;
  added.capture = {request.id, place.session.number, stored};
  added.planned = campaign.plan.captures;
  added.warnings = gathered.warnings;
  if (campaign.calibration.empty()) {
    added.warnings.emplace_back(
        "the campaign has no calibration yet; give the device's with --calibration, or these captures "
        "cannot be measured");
  }
  const Status committed = Commit(request, pictures, std::move(stored), &place);
  if (committed.ok()) return added;
  // Back to rest as far as the disk lets us; what it does not, the next command clears.
  static_cast<void>(RecoverCampaign(request.dir, lock).ok());
  return committed.error();
}

Result<std::optional<fs::path>> PresentCalibration(const fs::path& dir) {
  DORSUM_ASSIGN_OR_RETURN(const Campaign campaign, ReadCampaign(dir));
  if (campaign.calibration.empty()) return std::optional<fs::path>();
  return std::optional(CalibrationFile(dir, campaign.calibration));
}

}  // namespace dorsum
