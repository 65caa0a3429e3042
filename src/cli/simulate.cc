// SPDX-License-Identifier: Apache-2.0
#include "simulator/simulate.h"

#include <memory>

#include "cli/commands.h"
#include "simulator/scene_modifiers.h"

namespace dorsum {
namespace {

struct Arguments {
  SimulateOptions options;
  std::string out, device;
  bool no_calibration = false;
};

void Run(const Arguments& arguments, Session* session) {
  SimulateOptions options = arguments.options;
  options.device_path = arguments.device;
  options.calibration = !arguments.no_calibration;
  const Result<SimulateReport> report = Simulate(options, arguments.out, session->MakeContext());
  if (!report.ok()) return session->Fail(report.error());
  std::string text;
  if (report->calibration) text += arguments.out + "/calibration\n";
  for (const std::string& name : report->capture_names) text += arguments.out + "/captures/" + name + "\n";
  session->Print(
      text,
      {{"out", arguments.out}, {"calibration", report->calibration}, {"captures", report->capture_names}});
}

}  // namespace

void AddSimulate(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand("simulate",
                                    "Capture with the virtual device: a calibration series, objects, hands");
  c->add_option("-o,--out", arguments->out, "folder to write: calibration/, captures/NAME/, truth/")
      ->required();
  c->add_option("--device", arguments->device,
                "device description (TOML); the built-in four-laser device without it");
  c->add_option("--seed", arguments->options.seed,
                "names the true device, its mounting errors, scenes and noise")
      ->capture_default_str();
  c->add_option("--people-seed", arguments->options.people_seed,
                "names the people, to bring them to several devices");
  c->add_option(
      "--scene", arguments->options.scenes,
      "plane, plane_tilted, boxH, whiteboxH, cylinderR, sphereR, "
      "hand:man|woman:left|right:NAME[:kN]; with modifiers as listed below, and _rN for another noise");
  c->add_option("--population", arguments->options.population, "this many people, both hands of each (§5.3)")
      ->check(CLI::Range(0, 10000));
  c->add_option("--sessions", arguments->options.sessions, "captures of each hand")
      ->check(CLI::Range(1, 100));
  c->add_flag("--no-calibration", arguments->no_calibration, "leave the calibration series out");
  c->add_flag("--overwrite", arguments->options.overwrite,
              "replace what an earlier run wrote to the same folder");
  AddCommonOptions(c, session);
  c->footer("Modifiers of a scene (K: a laser's number; [n]: another number may follow the word):\n" +
            ModifierHelp() +
            "Example: dorsum simulate -o scan --scene box25.5 --scene hand:woman:right:anna+ring+dark");
  c->callback([arguments, session] { Run(*arguments, session); });
}

}  // namespace dorsum
