// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_virtual.h"

#include <algorithm>
#include <numeric>

#include "base/files.h"
#include "base/random.h"
#include "captures/device_description.h"
#include "jobs/calibrate.h"
#include "jobs/campaign_add.h"
#include "jobs/campaign_create.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_recovery.h"
#include "simulator/calibration_writer.h"
#include "simulator/capture_writer.h"
#include "simulator/population.h"
#include "simulator/virtual_device.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// The part of the progress that one step of many takes.
Context Part(const Context& context, double from, double to) {
  Context part = context;
  if (context.progress) {
    part.progress = [progress = context.progress, from, to](std::string_view stage, double fraction) {
      progress(stage, from + (to - from) * fraction);
    };
  }
  return part;
}

struct VirtualStation {
  VirtualDevice device;
  Campaign campaign;  // as it should be
};

Result<VirtualStation> SetUp(const VirtualCampaignRequest& request) {
  if (request.plan.people < 1 || request.plan.people > kMaxPeople)
    return UsageError("a virtual campaign has 1 to 10000 people");
  if (request.seed.size() > 200) return UsageError("a seed has at most 200 characters");
  DeviceDescription description = DefaultDevice();
  VirtualPeople people{request.seed, request.plan.people, ""};
  if (!request.device.empty()) {
    DORSUM_ASSIGN_OR_RETURN(description, ReadDeviceDescription(request.device));
    DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadFile(request.device));
    people.device_sha256 = Sha256Hex(text);
  }
  VirtualStation station{BuildVirtualDevice(description, NamedSeed(request.seed)), {}};
  Campaign& c = station.campaign;
  DORSUM_ASSIGN_OR_RETURN(c.name, NameOfNewCampaign(request.dir, request.name));
  DORSUM_RETURN_IF_ERROR(CheckPlan(request.plan));
  c.plan = request.plan;
  c.device = {description.name, description.camera.width, description.camera.height, {}};
  c.device.lasers.resize(description.lasers.size());
  std::iota(c.device.lasers.begin(), c.device.lasers.end(), 0);
  c.virtual_people = people;
  return station;
}

// An earlier run's campaign goes on only if it is the same.
Status CheckSame(const fs::path& dir, const Campaign& wanted) {
  DORSUM_ASSIGN_OR_RETURN(const Campaign there, ReadCampaign(dir));
  const bool same = there.virtual_people && there.virtual_people->seed == wanted.virtual_people->seed &&
                    there.virtual_people->people == wanted.virtual_people->people &&
                    there.virtual_people->device_sha256 == wanted.virtual_people->device_sha256 &&
                    there.plan.sessions == wanted.plan.sessions &&
                    there.plan.captures == wanted.plan.captures && there.plan.hands == wanted.plan.hands;
  if (same) return {};
  return BadInput(dir.string() +
                  " is a campaign already, and another one than asked for; choose another folder, or ask for "
                  "the same device, seed, people and plan to go on with it");
}

Status CalibrateStation(const VirtualCampaignRequest& request, const VirtualDevice& device,
                        const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(Campaign campaign, ReadCampaign(request.dir));
  if (!campaign.calibration.empty()) return {};  // an earlier run's
  std::string text;
  if (!request.calibration.empty()) {
    DORSUM_ASSIGN_OR_RETURN(text, ReadCampaignCalibration(request.calibration, &campaign.device));
  } else {
    DORSUM_ASSIGN_OR_RETURN(const WorkFolder work, [&]() -> Result<WorkFolder> {
      DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                              CampaignLock::Take(request.dir, CampaignLock::Kind::kWriter, context));
      DORSUM_RETURN_IF_ERROR(RecoverCampaign(request.dir, lock));
      return WorkFolder::Create(request.dir);
    }());
    const fs::path series = work.path() / "calibration", file = work.path() / "calibration.json";
    DORSUM_RETURN_IF_ERROR(WriteCalibrationSeries(device, series, context));
    const auto run = CalibrateFolder(series, file, {}, context);
    if (!run.ok()) return run.error();
    DORSUM_ASSIGN_OR_RETURN(text, ReadCampaignCalibration(file, &campaign.device));
  }
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(request.dir, CampaignLock::Kind::kWriter, context));
  return StoreCalibration(request.dir, text, &campaign, lock);
}

CaptureMaker Render(const VirtualDevice& device, const Person& person, const PersonCapture& capture,
                    const std::string& seed_text) {
  return [&device, person, capture, seed_text](const fs::path& folder, const Context& context) {
    const std::uint64_t seed = NamedSeed(seed_text);
    const SceneName name = SceneOf(person, capture);
    return WriteCapture(device, BuildNamedScene(device, name, seed, seed), {},
                        NamedSeed("capture/" + name.folder, seed), folder, {}, context);
  };
}

// One capture of the plan, unless an earlier run made it. Tells whether this one did.
Result<bool> MakeCapture(const VirtualCampaignRequest& request, const VirtualDevice& device,
                         const Person& person, const PersonCapture& capture, const Context& context) {
  const int session = capture.visit / request.plan.captures + 1;
  const CampaignHand hand = capture.side == Side::kLeft ? CampaignHand::kLeft : CampaignHand::kRight;
  DORSUM_ASSIGN_OR_RETURN(const std::vector<int> sessions, ListSessions(request.dir, person.id));
  if (std::find(sessions.begin(), sessions.end(), session) != sessions.end()) {
    const auto there = ReadSession(request.dir, person.id, session);
    if (!there.ok()) return there.error();
    if (there->Find(hand, capture.visit % request.plan.captures + 1) != nullptr) return false;
  }
  AddCaptureRequest add{request.dir, person.id, hand, session, {}, "the virtual capture " + capture.folder};
  const auto added = AddCapture(add, Render(device, person, capture, request.seed), context);
  if (!added.ok()) return added.error();
  return true;
}

Status MakePerson(const VirtualCampaignRequest& request, const Person& person, const Context& context) {
  std::error_code ec;
  if (fs::exists(PersonFolder(request.dir, person.id) / kPersonJson, ec)) return {};
  AddPersonRequest add{request.dir, {}, false, ""};
  add.person = {person.id, person.sex == Sex::kMan ? "man" : "woman", "not-said", "", true};
  return AddPerson(add, context);
}

}  // namespace

Result<VirtualCampaignSummary> MakeVirtualCampaign(const VirtualCampaignRequest& request,
                                                   const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const VirtualStation station, SetUp(request));
  std::error_code ec;
  if (fs::exists(request.dir / kCampaignJson, ec)) {
    DORSUM_RETURN_IF_ERROR(CheckSame(request.dir, station.campaign));
  } else {
    DORSUM_RETURN_IF_ERROR(WriteNewCampaign(request.dir, station.campaign, ""));
  }
  constexpr double kCalibrationShare = 0.1;
  DORSUM_RETURN_IF_ERROR(CalibrateStation(request, station.device, Part(context, 0.0, kCalibrationShare)));
  const CampaignPlan& plan = station.campaign.plan;
  VirtualCampaignSummary summary;
  const std::vector<Person> people = DrawPopulation(plan.people, plan.sessions * plan.captures);
  for (const Person& person : people) {
    DORSUM_RETURN_IF_ERROR(MakePerson(request, person, context));
    for (const PersonCapture& capture : person.captures) {
      const CampaignHand hand = capture.side == Side::kLeft ? CampaignHand::kLeft : CampaignHand::kRight;
      if (std::find(plan.hands.begin(), plan.hands.end(), hand) == plan.hands.end()) continue;
      const double all = static_cast<double>(plan.people) * plan.sessions * plan.captures *
                         static_cast<double>(plan.hands.size());
      context.Report("capture " + capture.folder,
                     kCalibrationShare + (1.0 - kCalibrationShare) * summary.captures / all);
      Context quiet = context;  // the single picture's progress would run back and forth
      quiet.progress = nullptr;
      DORSUM_ASSIGN_OR_RETURN(const bool made, MakeCapture(request, station.device, person, capture, quiet));
      summary.made += made ? 1 : 0;
      ++summary.captures;
    }
    ++summary.people;
  }
  DORSUM_ASSIGN_OR_RETURN(summary.campaign, ReadCampaign(request.dir));
  return summary;
}

}  // namespace dorsum
