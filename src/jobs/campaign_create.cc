// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_create.h"

#include <algorithm>
#include <numeric>

#include "base/files.h"
#include "calibration/calibration_file.h"
#include "captures/device_description.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

std::string Size(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

}  // namespace

Status CheckPlan(const CampaignPlan& plan) {
  if (plan.people < 0 || plan.people > kMaxPeople) return UsageError("a plan has 0 to 10000 people");
  if (plan.sessions < 1 || plan.sessions > kMaxSessions) return UsageError("a plan has 1 to 100 sessions");
  if (plan.captures < 1 || plan.captures > kMaxCaptures)
    return UsageError("a plan has 1 to 100 captures of each hand in each session");
  if (plan.hands.empty()) return UsageError("a plan has at least one hand");
  return {};
}

Result<std::string> NameOfNewCampaign(const fs::path& dir, const std::string& name) {
  std::error_code ec;
  fs::path clean = fs::absolute(dir, ec).lexically_normal();
  if (!clean.has_filename()) clean = clean.parent_path();
  const std::string given = name.empty() ? clean.filename().string() : name;
  DORSUM_RETURN_IF_ERROR(CheckCampaignName(given));
  return given;
}

Result<std::string> ReadCampaignCalibration(const fs::path& path, CampaignDevice* device) {
  DORSUM_ASSIGN_OR_RETURN(std::string text, ReadFile(path, std::size_t{256} << 20));
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) return BadInput(path.string() + " is not valid JSON; calibrate again");
  DORSUM_ASSIGN_OR_RETURN(const Calibration calibration, CalibrationFromJson(json, path.string()));
  const Camera& size = calibration.device.camera;
  std::vector<int> lasers;
  lasers.reserve(calibration.device.lasers.size());
  for (const LaserGeometry& laser : calibration.device.lasers) lasers.push_back(laser.laser);
  if (device->width == 0) {
    device->width = size.width;
    device->height = size.height;
  }
  if (device->lasers.empty()) device->lasers = lasers;
  if (size.width != device->width || size.height != device->height) {
    return BadInput(path.string() + " is of a camera with " + Size(size.width, size.height) +
                    " pixels, but the campaign's has " + Size(device->width, device->height) +
                    "; a campaign has one device");
  }
  for (const int laser : lasers) {
    if (std::find(device->lasers.begin(), device->lasers.end(), laser) == device->lasers.end()) {
      return BadInput(path.string() + " knows laser " + std::to_string(laser) +
                      ", which the campaign's device does not have; a campaign has one device");
    }
  }
  return text;
}

Status StoreCalibration(const fs::path& dir, const std::string& text, Campaign* campaign,
                        const CampaignLock& /*lock*/) {
  const std::string hash = Sha256Hex(text);
  std::error_code ec;
  if (!fs::exists(CalibrationFile(dir, hash), ec)) {
    DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(dir / kCalibrationsFolder));
    DORSUM_RETURN_IF_ERROR(WriteDurably(CalibrationFile(dir, hash), text));
  }
  campaign->calibration = hash;
  return WriteCampaign(dir, *campaign);
}

Status WriteNewCampaign(const fs::path& dir, const Campaign& campaign, const std::string& calibration) {
  std::error_code ec;
  if (fs::exists(dir / kCampaignJson, ec)) {
    return BadInput(dir.string() + " is a campaign already; add to it, or choose another folder");
  }
  if (fs::exists(dir, ec) && (!fs::is_directory(dir, ec) || !fs::is_empty(dir, ec))) {
    return BadInput(dir.string() + " is not an empty folder; choose another one for the campaign");
  }
  DORSUM_ASSIGN_OR_RETURN(StagedFolder staged, StagedFolder::Create(dir));
  const fs::path& root = staged.path();
  fs::permissions(root, fs::perms::owner_all, ec);
  DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(root / kPeopleFolder));
  DORSUM_RETURN_IF_ERROR(WriteDurably(root / kCampaignLock, ""));
  if (!calibration.empty()) {
    DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(root / kCalibrationsFolder));
    DORSUM_RETURN_IF_ERROR(WriteDurably(CalibrationFile(root, campaign.calibration), calibration));
  }
  DORSUM_RETURN_IF_ERROR(WriteCampaign(root, campaign));
  fs::remove(dir, ec);  // an empty folder makes room, so that all comes with one rename
  return staged.Commit();
}

Result<Campaign> CreateCampaign(const CreateCampaignRequest& request, const Context& context) {
  DORSUM_RETURN_IF_ERROR(CheckPlan(request.plan));
  Campaign campaign;
  DORSUM_ASSIGN_OR_RETURN(campaign.name, NameOfNewCampaign(request.dir, request.name));
  campaign.plan = request.plan;
  if (!request.device.empty()) {
    DORSUM_ASSIGN_OR_RETURN(const DeviceDescription device, ReadDeviceDescription(request.device));
    campaign.device = {device.name, device.camera.width, device.camera.height, {}};
    campaign.device.lasers.resize(device.lasers.size());
    std::iota(campaign.device.lasers.begin(), campaign.device.lasers.end(), 0);
  }
  std::string calibration;
  if (!request.calibration.empty()) {
    DORSUM_ASSIGN_OR_RETURN(calibration, ReadCampaignCalibration(request.calibration, &campaign.device));
    campaign.calibration = Sha256Hex(calibration);
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  DORSUM_RETURN_IF_ERROR(WriteNewCampaign(request.dir, campaign, calibration));
  return campaign;
}

}  // namespace dorsum
