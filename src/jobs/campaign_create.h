// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "base/context.h"
#include "base/result.h"
#include "jobs/campaign.h"
#include "jobs/campaign_disk.h"

namespace dorsum {

struct CreateCampaignRequest {
  std::filesystem::path dir;  // must not exist or be empty
  std::string name;           // empty: the folder's
  CampaignPlan plan;
  std::filesystem::path device;       // device.toml; empty: the first capture or calibration tells
  std::filesystem::path calibration;  // calibration.json of that device; empty: none yet
};

// The job behind `dorsum campaign new`: the folder appears whole, readable by its owner alone.
Result<Campaign> CreateCampaign(const CreateCampaignRequest& request, const Context& context);

// A usage error for a plan out of range.
Status CheckPlan(const CampaignPlan& plan);
// `name`, or the folder's where that is empty, if it can be one.
Result<std::string> NameOfNewCampaign(const std::filesystem::path& dir, const std::string& name);

// The same with all that is known already. `calibration` is the file's text, or empty.
Status WriteNewCampaign(const std::filesystem::path& dir, const Campaign& campaign,
                        const std::string& calibration);

// Reads a calibration and checks that it is of the campaign's device; a device that is not known yet is taken
// from it. Gives the file's text.
Result<std::string> ReadCampaignCalibration(const std::filesystem::path& path, CampaignDevice* device);

// Stores a calibration, once for all captures that were made with it, and makes it the present one. The
// writer's lock is to have been taken.
Status StoreCalibration(const std::filesystem::path& dir, const std::string& text, Campaign* campaign,
                        const CampaignLock& lock);

}  // namespace dorsum
