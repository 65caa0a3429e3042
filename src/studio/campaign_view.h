// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "jobs/campaign.h"
#include "jobs/campaign_status.h"

namespace dorsum {

// A campaign as its page shows it: people, their sessions, hands and captures, and what the plan still asks
// for.
struct CampaignHandView {
  CampaignHand hand = CampaignHand::kLeft;
  std::vector<CampaignCapture> captures;  // by number
  int missing = 0;                        // captures
};

struct CampaignSessionView {
  int number = 0;
  std::vector<CampaignHandView> hands;
};

struct CampaignPersonView {
  CampaignPerson person;
  std::vector<CampaignSessionView> sessions;  // those of the plan, and those that are there
  int captures = 0, missing = 0;
};

struct CampaignView {
  CampaignStatus status;
  std::vector<CampaignPersonView> people;  // by id; those that cannot be read are in status.problems
};

Result<std::shared_ptr<const CampaignView>> ReadCampaignView(const std::filesystem::path& dir,
                                                             const Context& context);

// None where nothing is there and nothing is asked for. Lives as long as the person's view.
const CampaignHandView* FindHand(const CampaignPersonView& person, int session, CampaignHand hand);

// What is to be captured next. With an id, of this person; with a session and a hand too, of these. None when
// the plan asks for nothing more there.
struct CampaignPlace {
  std::string id;                    // of a person who is there
  int session = 0;                   // 0: any
  std::optional<CampaignHand> hand;  // none: any
};
std::optional<MissingCaptures> NextMissing(const CampaignView& view, const CampaignPlace& place);

}  // namespace dorsum
