// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct.h"

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "jobs/reconstruct_batch.h"
#include "surface/mesh_export.h"

namespace dorsum {
namespace {

struct Arguments {
  ReconstructRequest request;
  OptionTable table = DescribeReconstructOptions(&request.options);
  std::string capture, calibration, out, settings;
  bool no_report = false, batch = false;
};

void RunOne(const ReconstructRequest& request, Session* session) {
  const Result<ReconstructSummary> summary = ReconstructFolder(request, session->MakeContext());
  if (!summary.ok()) return session->Fail(summary.error());
  session->Warn(summary->warnings);
  std::string text =
      std::to_string(summary->points) + " points, " + std::to_string(summary->faces) + " triangles\n";
  for (const std::string& file : summary->files) text += (request.out_dir / file).string() + "\n";
  session->Print(text, {{"points", summary->points},
                        {"triangles", summary->faces},
                        {"points_by_laser", summary->points_by_laser},
                        {"files", summary->files},
                        {"warnings", summary->warnings}});
}

// One line for each capture, one for all.
std::string BatchText(const BatchSummary& summary, const std::string& table) {
  std::size_t wide = 7;
  for (const BatchCapture& c : summary.captures) wide = std::max(wide, c.name.size());
  const auto line = [&](const std::string& name, const std::string& points, const std::string& faces,
                        const std::string& result) {
    const auto right = [](const std::string& t, std::size_t w) {
      return std::string(w - std::min(w, t.size()), ' ') + t;
    };
    return name + std::string(wide - name.size(), ' ') + right(points, 9) + right(faces, 11) + "  " + result +
           "\n";
  };
  std::string text = line("capture", "points", "triangles", "result");
  for (const BatchCapture& c : summary.captures) {
    const bool failed = c.outcome == BatchOutcome::kFailed;
    text += line(c.name, failed ? "-" : std::to_string(c.points), failed ? "-" : std::to_string(c.faces),
                 OutcomeText(c.outcome) + (failed ? ": " + c.error : ""));
  }
  return text + std::to_string(summary.captures.size()) +
         " captures: " + std::to_string(summary.Count(BatchOutcome::kDone)) + " done, " +
         std::to_string(summary.Count(BatchOutcome::kKept)) + " kept from before, " +
         std::to_string(summary.Count(BatchOutcome::kFailed)) + " failed\n" + table + "\n";
}

void RunBatch(const ReconstructRequest& request, Session* session) {
  const Result<BatchSummary> summary = ReconstructBatch(request, session->MakeContext());
  if (!summary.ok()) return session->Fail(summary.error());
  Json captures = Json::array();
  for (const BatchCapture& c : summary->captures) {
    for (const std::string& w : c.warnings) session->Warn({c.name + ": " + w});
    captures.push_back({{"capture", c.name},
                        {"result", OutcomeText(c.outcome)},
                        {"points", c.points},
                        {"triangles", c.faces},
                        {"error", c.error},
                        {"warnings", c.warnings}});
  }
  const std::string table = (request.out_dir / kBatchTable).string();
  session->Print(BatchText(*summary, table), {{"captures", captures},
                                              {"done", summary->Count(BatchOutcome::kDone)},
                                              {"kept", summary->Count(BatchOutcome::kKept)},
                                              {"failed", summary->Count(BatchOutcome::kFailed)},
                                              {"table", table}});
}

void Run(Arguments* arguments, CLI::App* command, Session* session) {
  if (const Status s = ReadSettings(arguments->settings, "reconstruct", command, &arguments->table);
      !s.ok()) {
    return session->Fail(s.error());
  }
  if (arguments->calibration.empty() && !(arguments->batch && HoldsCampaign(arguments->capture))) {
    return session->Fail(UsageError(
        "--calibration is required, but for --batch of a campaign; see dorsum reconstruct --help"));
  }
  ReconstructRequest& request = arguments->request;
  request.capture_dir = arguments->capture;
  request.calibration_path = arguments->calibration;
  request.out_dir = arguments->out;
  request.report = !arguments->no_report;
  arguments->batch ? RunBatch(request, session) : RunOne(request, session);
}

}  // namespace

void AddReconstruct(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand("reconstruct", "Turn a capture into a measured surface");
  c->add_option(
       "capture_dir", arguments->capture,
       "folder with bgHand and stripesHand0, stripesHand1, …; with --batch, a folder of such folders")
      ->required();
  c->add_option(
      "-c,--calibration", arguments->calibration,
      "calibration.json of the device; needed but for --batch of a campaign, whose captures have theirs");
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
  c->add_flag(
      "--batch", arguments->batch,
      "reconstruct every capture of a folder or campaign, each to a folder of its name in OUT; those that "
      "an earlier run did in the same way are kept");
  c->add_option("--settings", arguments->settings,
                "TOML file whose [reconstruct] table sets the options below");
  AddTable(c, &arguments->table);
  AddCommonOptions(c, session);
  c->footer(
      "Example: dorsum reconstruct scan/captures/box25.5 -c calibration.json -o box25.5\n"
      "         dorsum reconstruct scan/captures -c calibration.json -o surfaces --batch --no-report\n"
      "         dorsum reconstruct study -o surfaces --batch");
  c->callback([arguments, c, session] { Run(arguments.get(), c, session); });
}

}  // namespace dorsum
