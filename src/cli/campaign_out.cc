// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/campaign_commands.h"
#include "cli/commands.h"
#include "jobs/campaign_export.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_remove.h"

namespace dorsum {
namespace {

struct RemoveArguments {
  std::string dir, id, hand;
  int session = 0, capture = 0;
};

void RunExport(const ExportRequest& request, Session* session) {
  const auto summary = ExportCampaign(request, session->MakeContext());
  if (!summary.ok()) return session->Fail(summary.error());
  session->Warn(summary->warnings);
  session->Print(std::to_string(summary->people) + " people, " + std::to_string(summary->captures) +
                     " captures\n" + request.out_dir.string() + "\n",
                 {{"out", request.out_dir.string()},
                  {"people", summary->people},
                  {"captures", summary->captures},
                  {"attributes", summary->attributes},
                  {"warnings", summary->warnings}});
}

void RunRemove(const RemoveArguments& a, Session* session) {
  RemoveRequest request{a.dir, a.id, a.session, std::nullopt};
  if (a.capture > 0) request.capture = CaptureKey{*HandOfWord(a.hand), a.capture};
  const auto summary = RemoveFromCampaign(request, session->MakeContext());
  if (!summary.ok()) return session->Fail(summary.error());
  std::string text = "removed " + std::to_string(summary->captures) + " captures";
  if (!request.capture)
    text += " and the person; what was exported or reconstructed elsewhere is not reached";
  if (summary->finished) text = "finished a removal that had been interrupted";
  session->Print(text + "\n", {{"captures", summary->captures},
                               {"person", !request.capture},
                               {"finished_earlier", summary->finished}});
}

}  // namespace

void AddCampaignExport(CLI::App* campaign, Session* session) {
  struct Arguments {
    ExportRequest request;
    std::string dir, out;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* c = campaign->add_subcommand(
      "export", "Write the captures for others, under new random ids and without personal data");
  c->add_option("dir", a->dir, "the campaign's folder")->required();
  c->add_option("-o,--out", a->out, "folder to write")->required();
  c->add_flag("--groups", a->request.groups,
              "also tell sex and coarse age group, where groups are large enough");
  c->add_option("--least", a->request.least, "people that each such group must have")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  AddCommonOptions(c, session);
  c->footer("Example: dorsum campaign export study -o study-for-others");
  c->callback([a, session] {
    a->request.dir = a->dir;
    a->request.out_dir = a->out;
    RunExport(a->request, session);
  });
}

void AddCampaignRemove(CLI::App* campaign, Session* session) {
  auto a = std::make_shared<RemoveArguments>();
  CLI::App* c = campaign->add_subcommand(
      "remove", "Delete a person with all that the campaign holds of them, or one capture");
  c->add_option("dir", a->dir, "the campaign's folder")->required();
  c->add_option("--id", a->id, "the person")->required();
  auto* number =
      c->add_option("--session", a->session, "of the one capture")->check(CLI::Range(1, kMaxSessions));
  auto* hand =
      c->add_option("--hand", a->hand, "of the one capture")->check(CLI::IsMember({"left", "right"}));
  auto* capture = c->add_option("--capture", a->capture, "only this capture, to take it again")
                      ->check(CLI::Range(1, kMaxCaptures));
  capture->needs(number)->needs(hand);
  number->needs(capture);
  hand->needs(capture);
  AddCommonOptions(c, session);
  c->footer(
      "Example: dorsum campaign remove study --id p01\n"
      "         dorsum campaign remove study --id p01 --session 1 --hand left --capture 2");
  c->callback([a, session] { RunRemove(*a, session); });
}

}  // namespace dorsum
