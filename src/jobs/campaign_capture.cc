// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_capture.h"

#include <algorithm>
#include <filesystem>

#include "device/virtual_bench.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/capture.h"

namespace dorsum {
namespace {

// The scene of this visit, as `dorsum simulate` names scenes. Visits are counted through all sessions.
Result<std::string> SceneOfVisit(const AddCaptureRequest& request) {
  DORSUM_ASSIGN_OR_RETURN(const Campaign campaign, ReadCampaign(request.dir));
  DORSUM_ASSIGN_OR_RETURN(const CampaignPerson person, ReadPerson(request.dir, request.id));
  DORSUM_ASSIGN_OR_RETURN(const std::vector<int> sessions, ListSessions(request.dir, request.id));
  const int number = request.session.value_or(sessions.empty() ? 1 : sessions.back());
  int visit = (number - 1) * campaign.plan.captures;
  if (std::find(sessions.begin(), sessions.end(), number) != sessions.end()) {
    DORSUM_ASSIGN_OR_RETURN(const CampaignSession session, ReadSession(request.dir, request.id, number));
    for (int n = 1; session.Find(request.hand, n) != nullptr; ++n) ++visit;
  }
  return std::string("hand:") + (person.sex == "man" ? "man:" : "woman:") + HandWord(request.hand) + ":" +
         request.id + ":k" + std::to_string(visit);
}

}  // namespace

CaptureMaker CaptureWithDevice(Device* device, const AddCaptureRequest& request,
                               std::vector<std::string>* warnings) {
  return [=](const std::filesystem::path& folder, const Context& context) -> Status {
    CaptureRequest wanted;
    wanted.out_dir = folder;
    wanted.calibration_path = request.calibration;
    if (request.calibration.empty()) {
      DORSUM_ASSIGN_OR_RETURN(const auto present, PresentCalibration(request.dir));
      wanted.calibration_path = present.value_or("");
    }
    if (device->bench) {
      DORSUM_ASSIGN_OR_RETURN(const std::string scene, SceneOfVisit(request));
      DORSUM_RETURN_IF_ERROR(device->bench->PlaceNamed(scene));
    }
    DORSUM_ASSIGN_OR_RETURN(const CaptureSummary summary, CaptureToFolder(*device, wanted, context));
    *warnings = summary.warnings;
    return {};
  };
}

}  // namespace dorsum
