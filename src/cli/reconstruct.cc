// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct.h"

#include <memory>

#include "cli/commands.h"
#include "surface/mesh_export.h"

namespace dorsum {
namespace {

struct Arguments {
  ReconstructRequest request;
  OptionTable table = DescribeReconstructOptions(&request.options);
  std::string capture, calibration, out, settings;
  bool no_report = false;
};

void Run(Arguments* arguments, CLI::App* command, Session* session) {
  if (const Status s = ReadSettings(arguments->settings, "reconstruct", command, &arguments->table);
      !s.ok()) {
    return session->Fail(s.error());
  }
  ReconstructRequest& request = arguments->request;
  request.capture_dir = arguments->capture;
  request.calibration_path = arguments->calibration;
  request.out_dir = arguments->out;
  request.report = !arguments->no_report;
  const Result<ReconstructSummary> summary = ReconstructFolder(request, session->MakeContext());
  if (!summary.ok()) return session->Fail(summary.error());
  session->Warn(summary->warnings);
  std::string text =
      std::to_string(summary->points) + " points, " + std::to_string(summary->faces) + " triangles\n";
  for (const std::string& file : summary->files) text += arguments->out + "/" + file + "\n";
  session->Print(text, {{"points", summary->points},
                        {"triangles", summary->faces},
                        {"points_by_laser", summary->points_by_laser},
                        {"files", summary->files},
                        {"warnings", summary->warnings}});
}

}  // namespace

void AddReconstruct(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand("reconstruct", "Turn a capture into a measured surface");
  c->add_option("capture_dir", arguments->capture, "folder with bgHand and stripesHand0, stripesHand1, …")
      ->required();
  c->add_option("-c,--calibration", arguments->calibration, "calibration.json of the device")->required();
  c->add_option("-o,--out", arguments->out, "folder to write")->required();
  c->add_option("--method", arguments->request.options.method,
                "how, for all stages that say auto: ours (default) or the document's way (classic)")
      ->check(CLI::IsMember({"default", "classic"}))
      ->capture_default_str();
  c->add_option("--lasers", arguments->request.options.lasers, "use only these lasers: 0,1,2")
      ->delimiter(',')
      ->check(CLI::Range(0, 7));
  c->add_option("--mesh", arguments->request.mesh_formats, "mesh formats: ply,stl,obj,glb")
      ->delimiter(',')
      ->check(CLI::IsMember(MeshFormats()))
      ->default_str("ply");
  c->add_flag("--no-report", arguments->no_report, "write no report.html and overview.png");
  c->add_flag("--stages", arguments->request.stages,
              "also write every stage's intermediate image to OUT/stages");
  c->add_option("--settings", arguments->settings,
                "TOML file whose [reconstruct] table sets the options below");
  AddTable(c, &arguments->table);
  AddCommonOptions(c, session);
  c->footer("Example: dorsum reconstruct scan/captures/box25.5 -c calibration.json -o box25.5");
  c->callback([arguments, c, session] { Run(arguments.get(), c, session); });
}

}  // namespace dorsum
