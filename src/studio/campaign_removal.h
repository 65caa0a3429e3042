// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jobs/campaign.h"

class QWidget;

namespace dorsum {

// Asks before something of a campaign is lost, says what, and whether it was said to go on; the answer that
// comes first is no.
bool AskToRemoveCapture(const CampaignCapture& capture, QWidget* parent);
bool AskToRemovePerson(const std::string& id, const std::vector<CampaignCapture>& captures, QWidget* parent);

}  // namespace dorsum
