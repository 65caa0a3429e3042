// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "cli/session.h"

namespace dorsum {

// What `dorsum campaign` can do; each adds one of its commands.
void AddCampaignNew(CLI::App* campaign, Session* session);
void AddCampaignAdd(CLI::App* campaign, Session* session);
void AddCampaignStatus(CLI::App* campaign, Session* session);
void AddCampaignVerify(CLI::App* campaign, Session* session);
void AddCampaignExport(CLI::App* campaign, Session* session);
void AddCampaignRemove(CLI::App* campaign, Session* session);

}  // namespace dorsum
