// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "base/context.h"
#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

struct VirtualCampaignRequest {
  std::filesystem::path dir;
  std::string name;                   // empty: the folder's
  CampaignPlan plan;                  // its people, 1 to 10000, come all
  std::string seed = "1";             // of device and people, as in `simulate --seed`
  std::filesystem::path device;       // device.toml; empty: the built-in four-laser device
  std::filesystem::path calibration;  // of that virtual device; empty: it is calibrated first
};

struct VirtualCampaignSummary {
  Campaign campaign;
  int people = 0, captures = 0;  // all that are there now
  int made = 0;                  // captures of this run
};

// The document's database (§5.3: 18 men and 2 women of 20, both hands) with the virtual device: calibrates it
// and captures everybody, one capture after the other. A run that was interrupted goes on from the same
// command. The pictures are those that `dorsum simulate --seed SEED --population N --sessions S*K` makes for
// the same device, byte for byte, so that their truth can be had: capture k of session s is the visit
// (s - 1) * K + k - 1.
Result<VirtualCampaignSummary> MakeVirtualCampaign(const VirtualCampaignRequest& request,
                                                   const Context& context);

}  // namespace dorsum
