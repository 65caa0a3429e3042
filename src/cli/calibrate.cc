// SPDX-License-Identifier: Apache-2.0
#include "jobs/calibrate.h"

#include <cstdio>
#include <memory>

#include "cli/commands.h"

namespace dorsum {
namespace {

struct Arguments {
  std::string dir, out;
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

void Run(const Arguments& arguments, Session* session) {
  const Result<CalibrationRun> run =
      CalibrateFolder(arguments.dir, arguments.out, arguments.options, session->MakeContext());
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
  c->add_option("calibration_dir", arguments->dir, "folder with setup.json and the images of §3.2")
      ->required();
  c->add_option("-o,--out", arguments->out,
                "file to write; a report of the same name with .html comes beside it")
      ->required();
  c->add_option(
       "--method", arguments->options.method,
       "how: cones by one adjustment over all boards and stripes (bundle), or the document's way (classic)")
      ->check(CLI::IsMember({"bundle", "classic"}))
      ->capture_default_str();
  AddCommonOptions(c, session);
  c->footer("Example: dorsum calibrate scan/calibration -o calibration.json");
  c->callback([arguments, session] { Run(*arguments, session); });
}

}  // namespace dorsum
