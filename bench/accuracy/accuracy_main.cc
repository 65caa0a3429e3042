// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>

#include "accuracy/document.h"
#include "accuracy/guard.h"
#include "accuracy/plan.h"
#include "accuracy/run_device.h"
#include "accuracy/summary.h"
#include "accuracy/synthetic_stripes.h"
#include "accuracy/tables.h"
#include "base/files.h"
#include "base/version.h"
#include "cli/session.h"

namespace dorsum::accuracy {
namespace {

namespace fs = std::filesystem;

const fs::path kBench = fs::path(DORSUM_SOURCE_DIR) / "bench/accuracy";

struct Arguments {
  std::vector<std::string> designs, seeds, rungs;
  std::string seed_set = "held-out", captures, cache, results, write, check;
  bool no_devices = false, brief = false, record = false;
};

Result<std::vector<Rung>> ChooseRungs(const Arguments& arguments) {
  const std::vector<Rung> ladder = Ladder();
  if (arguments.rungs.empty()) return ladder;
  std::vector<Rung> chosen;
  for (const Rung& rung : ladder) {
    const bool first = &rung == &ladder.front(), last = &rung == &ladder.back();
    for (const std::string& name : arguments.rungs) {
      if (name == rung.name || (name == "classic" && first) || (name == "default" && last)) {
        chosen.push_back(rung);
        break;
      }
    }
  }
  if (!chosen.empty()) return chosen;
  std::string known;
  for (const Rung& rung : ladder) known += (known.empty() ? "" : "; ") + rung.name;
  return UsageError("there is no such way of reconstructing; known are: classic; default; " + known);
}

RunOptions Options(const std::vector<Rung>& rungs) {
  RunOptions options;
  options.budget_of = {rungs.front().name, rungs.back().name};
  options.said = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  return options;
}

Result<Results> RunPlan(const Arguments& arguments, const std::vector<Rung>& rungs, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const std::vector<DesignPlan> plan, ReadPlan(kBench / "plan.toml"));
  Results results{kVersion, {}};
  for (const DesignPlan& design : plan) {
    const bool named = std::count(arguments.designs.begin(), arguments.designs.end(), design.name) > 0;
    if (arguments.designs.empty() ? !design.in_default_run : !named) continue;
    std::vector<std::string> seeds = arguments.seed_set == "tuning" ? design.tuning : design.held_out;
    if (!arguments.seeds.empty()) seeds = arguments.seeds;
    for (const std::string& seed : seeds) {
      DORSUM_ASSIGN_OR_RETURN(const DeviceData data, RenderDevice(design.name, design.device, seed,
                                                                  design.scenes, arguments.cache, context));
      DORSUM_ASSIGN_OR_RETURN(std::vector<DeviceResult> done,
                              RunDevice(data, rungs, Options(rungs), context));
      std::move(done.begin(), done.end(), std::back_inserter(results.devices));
    }
  }
  if (results.devices.empty()) return UsageError("the plan has no such design");
  return results;
}

Result<Results> RunCaptures(const Arguments& arguments, const std::vector<Rung>& rungs,
                            const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const DeviceData data,
                          FindCaptures(arguments.captures, fs::path(arguments.cache) / "captures-out"));
  DORSUM_ASSIGN_OR_RETURN(std::vector<DeviceResult> done, RunDevice(data, rungs, Options(rungs), context));
  return Results{kVersion, std::move(done)};
}

// `group` names the design in asked.toml; empty: each design's own name.
Status Print(const Results& results, const std::string& group) {
  DORSUM_ASSIGN_OR_RETURN(const LimitTable asked, ReadLimits(kBench / "asked.toml"));
  for (const std::string& design : DesignsOf(results)) {
    const std::string acceptance = AcceptanceTable(results, design, group.empty() ? design : group, asked);
    std::printf("\n## %s\n", design.c_str());
    if (acceptance.empty()) {
      std::printf("\n%s", CaptureTable(results, design, RungsOf(results, design).back()).c_str());
      continue;
    }
    std::printf("\nAsked and reached\n\n%s\nOne stage at a time\n\n%s\nWhere the errors come from\n\n%s",
                acceptance.c_str(), LadderTable(results, design).c_str(),
                BudgetTable(results, design).c_str());
  }
  return {};
}

Status Record(const Results& results, const std::string& name, const Arguments& arguments) {
  if (arguments.results.empty()) return {};
  std::error_code ignored;
  fs::create_directories(arguments.results, ignored);
  return WriteJson(fs::path(arguments.results) / (name + ".json"), ResultsToJson(results));
}

Status Finish(const Results& results, const std::string& name, const std::string& group,
              const Arguments& arguments) {
  DORSUM_RETURN_IF_ERROR(Record(results, name, arguments));
  return Print(results, group);
}

Status RunStripes(const Arguments& arguments, const Context& context) {
  constexpr std::uint64_t kSeed = 20;  // not one of the tests'
  const Results results{kVersion, {MeasureSyntheticStripes(kSeed, context)}};
  std::printf("\n## synthetic stripes\n\n%s", SyntheticTable(results.devices.front()).c_str());
  return Record(results, "stripes", arguments);
}

Status RunShort(const Arguments& arguments, const Context& context) {
  Arguments of_short = arguments;
  of_short.designs = {"short"};
  const std::vector<Rung> ladder = Ladder();
  std::vector<Rung> ends = {ladder.front()};
  if (ladder.size() > 1) ends.push_back(ladder.back());
  DORSUM_ASSIGN_OR_RETURN(const Results results, RunPlan(of_short, ends, context));
  const fs::path limits = kBench / "limits.toml";
  if (arguments.record) {
    return WriteLimits(
        limits,
        "# SPDX-License-Identifier: Apache-2.0\n"
        "# Written by `accuracy --short --record`: what the short run reached, and a tenth more. Record\n"
        "# again when figures get better; when one gets worse on purpose, the commit says why.\n",
        RecordLimits(results));
  }
  DORSUM_ASSIGN_OR_RETURN(const LimitTable recorded, ReadLimits(limits));
  const std::vector<std::string> worse = Regressions(results, recorded);
  if (worse.empty()) return {};
  std::string all = "accuracy got worse";
  for (const std::string& line : worse) all += "\n  " + line;
  return Error{ErrorCode::kAnswerIsNo, all};
}

Status Document(const Arguments& arguments) {
  DORSUM_ASSIGN_OR_RETURN(const std::string text, MakeDocument(kBench));
  if (!arguments.write.empty()) return WriteFile(arguments.write, text);
  DORSUM_ASSIGN_OR_RETURN(const std::string there, ReadFile(arguments.check));
  if (there == text) return {};
  return Error{ErrorCode::kAnswerIsNo,
               arguments.check + " is not what its template and results give; write it anew"};
}

Status RunAll(const Arguments& arguments, const Context& context) {
  if (arguments.brief) return RunShort(arguments, context);
  DORSUM_ASSIGN_OR_RETURN(const std::vector<Rung> rungs, ChooseRungs(arguments));
  if (!arguments.captures.empty()) {
    DORSUM_ASSIGN_OR_RETURN(const Results results, RunCaptures(arguments, rungs, context));
    DORSUM_RETURN_IF_ERROR(Finish(results, "captures", "four lasers", arguments));
  }
  if (!arguments.no_devices) {
    DORSUM_ASSIGN_OR_RETURN(const Results results, RunPlan(arguments, rungs, context));
    DORSUM_RETURN_IF_ERROR(Finish(results, "devices", "", arguments));
    DORSUM_RETURN_IF_ERROR(RunStripes(arguments, context));
  }
  if (!arguments.write.empty() || !arguments.check.empty()) return Document(arguments);
  return {};
}

int Run(int argc, char** argv) {
  Session session;
  Arguments arguments;
  arguments.cache = (fs::temp_directory_path() / "dorsum-accuracy").string();
  CLI::App app(
      "Accuracy against a truth: random devices, objects and hands; one stage at a time from the document's\n"
      "method to ours; what is asked beside what is reached; where the remaining errors come from.");
  app.add_option("--design", arguments.designs, "only these designs of bench/accuracy/plan.toml");
  app.add_option("--seeds", arguments.seed_set, "which of the plan's seeds")
      ->check(CLI::IsMember({"held-out", "tuning"}))
      ->capture_default_str();
  app.add_option("--seed", arguments.seeds, "these seeds instead");
  app.add_option("--rung", arguments.rungs,
                 "only these rungs of the ladder: classic, default, or a rung's name");
  app.add_option("--captures", arguments.captures, "also a folder of calibration/, captures/ and truth/");
  app.add_flag("--no-devices", arguments.no_devices, "leave the plan's devices out");
  app.add_option("--cache", arguments.cache, "folder that keeps rendered devices, and what is made of them")
      ->capture_default_str();
  app.add_option("--results", arguments.results, "folder to record the results in (bench/accuracy/results)");
  app.add_option("--write", arguments.write,
                 "write the document from the recorded results (docs/accuracy.md)");
  app.add_option("--check", arguments.check, "fail unless this document is what --write would write");
  app.add_flag("--short", arguments.brief,
               "one small device only; fails where a figure is worse than recorded");
  app.add_flag("--record", arguments.record, "with --short: record these figures as the limits")
      ->needs("--short");
  app.add_option("--threads", session.threads, "0: one for each processor")->check(CLI::Range(0, 1024));
  app.footer(
      "Example: accuracy --captures CAPTURES_DIR --cache /tmp/accuracy --results "
      "bench/accuracy/results "
      "--write docs/accuracy.md");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : ExitCode(ErrorCode::kUsage);
  }
  Context context = session.MakeContext();
  context.progress = nullptr;  // a line for each capture tells more
  if (const Status done = RunAll(arguments, context); !done.ok()) session.Fail(done.error());
  return session.Finish();
}

}  // namespace
}  // namespace dorsum::accuracy

int main(int argc, char** argv) {
  dorsum::CatchInterrupts();
  try {
    return dorsum::accuracy::Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "accuracy: %s\n", error.what());
  }
  return dorsum::ExitCode(dorsum::ErrorCode::kInternal);
}
