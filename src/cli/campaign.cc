// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/campaign_commands.h"
#include "cli/commands.h"

namespace dorsum {

void AddCampaign(CLI::App* app, Session* session) {
  CLI::App* c = app->add_subcommand(
      "campaign", "Collect captures of many people: with consent, checksums and deletion (§5.3)");
  c->require_subcommand(1);
  AddCampaignNew(c, session);
  AddCampaignAdd(c, session);
  AddCampaignStatus(c, session);
  AddCampaignVerify(c, session);
  AddCampaignExport(c, session);
  AddCampaignRemove(c, session);
  AddCommonOptions(c, session);
  c->footer(
      "Example: dorsum campaign new study --captures 3 --sessions 2\n"
      "         dorsum campaign new virtual --virtual 1 --people 20");
}

}  // namespace dorsum
