// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_add.h"

#include <memory>

#include "cli/campaign_commands.h"
#include "cli/commands.h"
#include "device/device.h"
#include "jobs/campaign_capture.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

struct Arguments {
  std::string dir, hand, from, device, calibration;
  CampaignPerson person{"", "not-said", "not-said", "", false};
  bool correct = false;
  int session = 0;
};

void RunPerson(const Arguments& a, Session* session) {
  const Status added = AddPerson({a.dir, a.person, a.correct, ""}, session->MakeContext());
  if (!added.ok()) return session->Fail(added.error());
  session->Print("person " + a.person.id + "\n", {{"person", a.person.id}});
}

// Opens the device only when all that can be known beforehand is in order.
CaptureMaker CaptureWith(const std::string& device, const AddCaptureRequest& request,
                         std::vector<std::string>* warnings) {
  return [=](const std::filesystem::path& folder, const Context& context) -> Status {
    DORSUM_ASSIGN_OR_RETURN(Device open, OpenDevice(device, context));
    return CaptureWithDevice(&open, request, warnings)(folder, context);
  };
}

void RunCapture(const Arguments& a, Session* session) {
  if (a.from.empty() == a.device.empty())
    return session->Fail(
        UsageError("--hand needs one of --from and --device; see dorsum campaign add --help"));
  const std::string source = a.from.empty() ? "the capture with " + a.device : a.from;
  std::vector<std::string> warnings;
  AddCaptureRequest request{a.dir, a.person.id, *HandOfWord(a.hand), std::nullopt, a.calibration, source};
  if (a.session > 0) request.session = a.session;
  const auto added =
      AddCapture(request, a.from.empty() ? CaptureWith(a.device, request, &warnings) : ImportCapture(a.from),
                 session->MakeContext());
  if (!added.ok()) return session->Fail(added.error());
  warnings.insert(warnings.end(), added->warnings.begin(), added->warnings.end());
  session->Warn(warnings);
  const CampaignCapture& c = added->capture;
  session->Print(c.Folder(a.dir).string() + "\n" + a.hand + " hand, session " + std::to_string(c.session) +
                     ": capture " + std::to_string(c.stored.number) + " of " +
                     std::to_string(added->planned) + "\n",
                 {{"person", c.id},
                  {"session", c.session},
                  {"hand", a.hand},
                  {"capture", c.stored.number},
                  {"planned", added->planned},
                  {"folder", c.Folder(a.dir).string()},
                  {"warnings", warnings}});
}

}  // namespace

void AddCampaignAdd(CLI::App* campaign, Session* session) {
  auto a = std::make_shared<Arguments>();
  CLI::App* c = campaign->add_subcommand("add", "Add a person with the date of the consent, or a capture");
  c->add_option("dir", a->dir, "the campaign's folder")->required();
  c->add_option("--id", a->person.id, "pseudonymous id: p01, never a name")->required();
  auto* sex = c->add_option("--sex", a->person.sex, "of a new person")->check(CLI::IsMember(CampaignSexes()));
  auto* age = c->add_option("--age-group", a->person.age_group, "of a new person, years")
                  ->check(CLI::IsMember(CampaignAgeGroups()));
  auto* consent = c->add_option("--consent-date", a->person.consent_date,
                                "of a new person: the day of the consent, YYYY-MM-DD");
  auto* correct =
      c->add_flag("--correct", a->correct, "the person is there already: replace what was said of them");
  auto* hand = c->add_option("--hand", a->hand, "of the capture")->check(CLI::IsMember({"left", "right"}));
  auto* number = c->add_option("--session", a->session, "visit of the person; the last one without it")
                     ->check(CLI::Range(1, kMaxSessions));
  auto* from = c->add_option("--from", a->from, "capture folder to import: bgHand, stripesHand0, …");
  auto* device =
      c->add_option("--device", a->device, "capture with this device: device.toml, or virtual[:SEED]");
  auto* calibration = c->add_option("-c,--calibration", a->calibration,
                                    "calibration.json of the device from this capture on");
  // Either a person or a capture.
  for (CLI::Option* of_capture : {number, from, device, calibration}) of_capture->needs(hand);
  for (CLI::Option* of_person : {sex, age, consent, correct}) of_person->excludes(hand);
  from->excludes(device);
  AddCommonOptions(c, session);
  c->footer(
      "Example: dorsum campaign add study --id p01 --sex woman --age-group 20-29 --consent-date 2024-05-31\n"
      "         dorsum campaign add study --id p01 --hand left --from captures/hand1\n"
      "         dorsum campaign add study --id p01 --hand left --device device.toml");
  c->callback([a, session] { a->hand.empty() ? RunPerson(*a, session) : RunCapture(*a, session); });
}

}  // namespace dorsum
