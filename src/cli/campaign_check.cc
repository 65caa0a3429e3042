// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/campaign_commands.h"
#include "cli/commands.h"
#include "jobs/campaign_status.h"
#include "jobs/campaign_verify.h"

namespace dorsum {

void AddCampaignStatus(CLI::App* campaign, Session* session) {
  struct Arguments {
    std::string dir, surfaces;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* c = campaign->add_subcommand("status", "Who came, what was captured, what is missing");
  c->add_option("dir", a->dir, "the campaign's folder")->required();
  c->add_option("--surfaces", a->surfaces,
                "what dorsum reconstruct DIR -o SURFACES --batch wrote: tells the quality of the captures");
  AddCommonOptions(c, session);
  c->footer("Example: dorsum campaign status study");
  c->callback([a, session] {
    const auto status = StatusOfCampaign(a->dir, a->surfaces, session->MakeContext());
    if (!status.ok()) return session->Fail(status.error());
    session->Print(StatusToText(*status), StatusToJson(*status));
  });
}

void AddCampaignVerify(CLI::App* campaign, Session* session) {
  auto dir = std::make_shared<std::string>();
  CLI::App* c = campaign->add_subcommand(
      "verify",
      "Read every byte: is all as it was stored? Exit code 1 if anything is missing, changed or new");
  c->add_option("dir", *dir, "the campaign's folder")->required();
  AddCommonOptions(c, session);
  c->footer("Example: dorsum campaign verify study");
  c->callback([dir, session] {
    const auto verification = VerifyCampaign(*dir, session->MakeContext());
    if (!verification.ok()) return session->Fail(verification.error());
    session->Print(VerificationToText(*verification), VerificationToJson(*verification));
    if (verification->findings.empty()) return;
    session->Fail({ErrorCode::kAnswerIsNo, *dir + " is not as it was stored"});
  });
}

}  // namespace dorsum
