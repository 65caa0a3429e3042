// SPDX-License-Identifier: Apache-2.0
#include "jobs/evaluate.h"

#include <map>
#include <memory>

#include "cli/commands.h"

namespace dorsum {
namespace {

struct Arguments {
  EvaluateRequest request;
  std::string dir, fit, against;
  std::vector<std::string> repeats;
  double plane_height = 0.0, max_rmse = 0.0;
};

const std::map<std::string, Shape>& Shapes() {
  static const std::map<std::string, Shape> kShapes = {
      {"plane", Shape::kPlane}, {"sphere", Shape::kSphere}, {"cylinder", Shape::kCylinder}};
  return kShapes;
}

void Run(Arguments* arguments, const CLI::App& command, Session* session) {
  EvaluateRequest& request = arguments->request;
  request.out_dirs.emplace_back(arguments->dir);
  request.out_dirs.insert(request.out_dirs.end(), arguments->repeats.begin(), arguments->repeats.end());
  if (command.count("--plane-height") > 0) request.plane_height_mm = arguments->plane_height;
  if (!arguments->fit.empty()) request.fit = Shapes().at(arguments->fit);
  if (!arguments->against.empty()) request.against = arguments->against;
  const Result<Evaluation> evaluation = Evaluate(request, session->MakeContext());
  if (!evaluation.ok()) return session->Fail(evaluation.error());
  session->Print(EvaluationToText(*evaluation), EvaluationToJson(*evaluation));
  const double rmse = evaluation->captures.front().models.back().rmse_mm;
  if (command.count("--max-rmse") > 0 && rmse > arguments->max_rmse) {
    session->Fail(
        {ErrorCode::kAnswerIsNo, "the merged RMSE is above " + std::to_string(arguments->max_rmse) + " mm"});
  }
}

}  // namespace

void AddEvaluate(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c =
      app->add_subcommand("evaluate", "Measure how far a reconstruction is from what it should be (§5.1)");
  c->add_option("out_dir", arguments->dir, "folder that reconstruct wrote")->required();
  auto* plane = c->add_option("--plane-height", arguments->plane_height, "a flat top at this height, mm")
                    ->check(NumberFrom(-1000.0, 1000.0));
  auto* fit = c->add_option("--fit", arguments->fit, "a shape fitted to the points")
                  ->check(CLI::IsMember({"plane", "sphere", "cylinder"}));
  auto* against =
      c->add_option("--against", arguments->against, "a reference mesh (PLY) in the same world frame");
  plane->excludes(fit)->excludes(against);
  fit->excludes(against);
  c->add_option("--repeat", arguments->repeats,
                "further reconstructions of the same object, for the differences (5.2)");
  c->add_option("--shrink-px", arguments->request.shrink_px, "how much the mask is shrunk, px")
      ->check(NumberFrom(0.0, 100.0))
      ->capture_default_str();
  c->add_option("--max-rmse", arguments->max_rmse,
                "answer no (exit code 1) when the merged RMSE is above this, mm")
      ->check(NumberFrom(0.0, 1e6));
  AddCommonOptions(c, session);
  c->footer("Example: dorsum evaluate box25.5 --plane-height 25.5");
  c->callback([arguments, c, session] { Run(arguments.get(), *c, session); });
}

}  // namespace dorsum
