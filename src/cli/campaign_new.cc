// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/campaign_commands.h"
#include "cli/commands.h"
#include "jobs/campaign_create.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_virtual.h"

namespace dorsum {
namespace {

struct Arguments {
  std::string dir, name, hands = "both", device, calibration, seed;
  CampaignPlan plan;
};

void RunVirtual(const Arguments& a, const CampaignPlan& plan, Session* session) {
  VirtualCampaignRequest request{a.dir, a.name, plan, a.seed, a.device, a.calibration};
  if (plan.people == 0) request.plan.people = VirtualPeople{}.people;
  const auto summary = MakeVirtualCampaign(request, session->MakeContext());
  if (!summary.ok()) return session->Fail(summary.error());
  session->Print(std::to_string(summary->people) + " virtual people, " + std::to_string(summary->captures) +
                     " captures, " + std::to_string(summary->made) + " of them new\n" + a.dir + "\n",
                 {{"campaign", a.dir},
                  {"virtual", true},
                  {"people", summary->people},
                  {"captures", summary->captures},
                  {"captures_new", summary->made}});
}

void Run(const Arguments& a, const CLI::App& command, Session* session) {
  CampaignPlan plan = a.plan;
  if (a.hands != "both") plan.hands = {*HandOfWord(a.hands)};
  if (command.count("--virtual") > 0) return RunVirtual(a, plan, session);
  const auto campaign =
      CreateCampaign({a.dir, a.name, plan, a.device, a.calibration}, session->MakeContext());
  if (!campaign.ok()) return session->Fail(campaign.error());
  session->Print(a.dir + "\n", {{"campaign", a.dir}, {"virtual", false}, {"name", campaign->name}});
}

}  // namespace

void AddCampaignNew(CLI::App* campaign, Session* session) {
  auto a = std::make_shared<Arguments>();
  CLI::App* c = campaign->add_subcommand("new", "Begin a campaign, or make one of virtual people");
  c->add_option("dir", a->dir, "folder to make")->required();
  c->add_option("--name", a->name, "name for people to read; the folder's without it");
  c->add_option("--people", a->plan.people, "people who are hoped for; with --virtual, 20 without it")
      ->check(CLI::Range(1, kMaxPeople));
  c->add_option("--sessions", a->plan.sessions, "visits of each person")
      ->check(CLI::Range(1, kMaxSessions))
      ->capture_default_str();
  c->add_option("--captures", a->plan.captures, "captures of each hand in each session")
      ->check(CLI::Range(1, kMaxCaptures))
      ->capture_default_str();
  c->add_option("--hands", a->hands, "which hands")
      ->check(CLI::IsMember({"left", "right", "both"}))
      ->capture_default_str();
  c->add_option("--device", a->device,
                "device description (TOML); without it the first capture or calibration tells, or, with "
                "--virtual, it is the built-in four-laser device");
  c->add_option("-c,--calibration", a->calibration, "calibration.json of the device");
  c->add_option("--virtual", a->seed,
                "capture virtual people with the virtual device of this seed, calibrating it first; the same "
                "command goes on after an interrupt");
  AddCommonOptions(c, session);
  c->footer(
      "Example: dorsum campaign new study --people 20 --captures 3 -c calibration.json\n"
      "         dorsum campaign new virtual --virtual 1 --people 20");
  c->callback([a, c, session] { Run(*a, *c, session); });
}

}  // namespace dorsum
