// SPDX-License-Identifier: Apache-2.0
#include "jobs/calibrate.h"

#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/terminal_attendant.h"
#include "jobs/live_series.h"

namespace dorsum {
namespace {

struct Arguments {
  std::string dir, out = "calibration.json", device;
  bool live = false;
  int average = 1;
  CalibrateOptions options;
};

std::string Summary(const Calibration& calibration) {
  std::string text;
  for (const PartReport& part : calibration.parts) {
    text += part.part + ": " + GradeName(part.grade) + ", " + part.verdict + "\n";
    for (const Figure& f : part.figures) {
      char line[128];
      std::snprintf(line, sizeof line, "  %-42s %12.4f %s\n", f.name.c_str(), f.value, f.unit.c_str());
      text += line;
    }
  }
  return text;
}

// Takes the series with a device; the folder then holds it.
Status TakeSeries(const Arguments& arguments, const Context& context, Session* session) {
  if (arguments.device.empty()) return UsageError("--live needs --device: a device description, or virtual");
  DORSUM_ASSIGN_OR_RETURN(Device device, OpenDevice(arguments.device, context));
  const auto attendant = device.bench ? MakeVirtualAttendant(device.bench) : MakeTerminalAttendant(session);
  LiveSeriesRequest request;
  request.dir = arguments.dir;
  request.average = arguments.average;
  DORSUM_ASSIGN_OR_RETURN(const LiveSeriesSummary summary,
                          TakeCalibrationSeries(device, *attendant, request, context));
  session->Warn(summary.warnings);
  return {};
}

void Run(Arguments arguments, Session* session) {
  if (arguments.dir.empty()) {
    if (!arguments.live)
      return session->Fail(UsageError("calibration_dir is required; see dorsum calibrate --help"));
    arguments.dir = "calibration";
  }
  const Context context = session->MakeContext();
  if (arguments.live) {
    if (const Status taken = TakeSeries(arguments, context, session); !taken.ok()) {
      return session->Fail(taken.error());
    }
  }
  const Result<CalibrationRun> run =
      CalibrateFolder(arguments.dir, arguments.out, arguments.options, context);
  if (!run.ok()) return session->Fail(run.error());
  session->Warn(run->calibration.warnings);
  Json parts = CalibrationToJson(run->calibration)["parts"];
  std::string text = Summary(run->calibration);
  for (const std::string& file : run->files) text += file + "\n";
  session->Print(text, {{"files", run->files}, {"parts", parts}, {"warnings", run->calibration.warnings}});
}

}  // namespace

void AddCalibrate(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand("calibrate", "Calibrate camera and lasers from a calibration series");
  c->add_option(
      "calibration_dir", arguments->dir,
      "folder with setup.json and the images of §3.2; with --live it is filled, and ./calibration if it "
      "is not named");
  c->add_option("-o,--out", arguments->out,
                "file to write; a report of the same name with .html comes beside it")
      ->capture_default_str();
  c->add_flag("--live", arguments->live,
              "take the series first, step by step; what the folder holds already is kept, so that a broken "
              "series goes on");
  c->add_option("--device", arguments->device, "with --live: device description (TOML), or virtual[:SEED]");
  c->add_option("--average", arguments->average, "with --live: frames averaged for each picture")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  c->add_option(
       "--method", arguments->options.method,
       "how: cones by one adjustment over all boards and stripes (bundle), or the document's way (classic)")
      ->check(CLI::IsMember({"bundle", "classic"}))
      ->capture_default_str();
  AddCommonOptions(c, session);
  c->footer(
      "Example: dorsum calibrate scan/calibration -o calibration.json\n"
      "With a device: dorsum calibrate series --live --device device.toml -o calibration.json");
  c->callback([arguments, session] { Run(*arguments, session); });
}

}  // namespace dorsum
