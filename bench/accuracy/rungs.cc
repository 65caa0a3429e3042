// SPDX-License-Identifier: Apache-2.0
#include "accuracy/rungs.h"

#include <stdexcept>
#include <utility>

#include "jobs/calibrate.h"

namespace dorsum::accuracy {
namespace {

using Choices = std::vector<std::pair<std::string, std::string>>;

// The document's choice of each stage (DESIGN §3).
const Choices kClassic = {{"mask", "classic"}, {"stripes", "classic"},       {"indexing", "classic"},
                          {"sheets", "plane"}, {"correction", "polynomial"}, {"fusion", "classic"}};

std::string Get(const std::string& stage) {
  ReconstructOptions defaults;
  const OptionTable table = DescribeReconstructOptions(&defaults);
  for (const OptionSpec& spec : table.specs()) {
    if (spec.name == stage) return OptionTable::ValueText(spec);
  }
  throw std::logic_error("no stage " + stage);
}

void Set(const std::string& stage, const std::string& value, ReconstructOptions* options) {
  OptionTable table = DescribeReconstructOptions(options);
  if (const Status set = table.Set(stage, value); !set.ok()) throw std::logic_error(set.error().message);
}

}  // namespace

std::vector<Rung> Ladder() {
  Rung rung{"classic", "classic", {}};
  for (const auto& [stage, value] : kClassic) Set(stage, value, &rung.options);
  std::vector<Rung> ladder = {rung};
  const std::string calibration = CalibrateOptions{}.method;
  // Sheets, their correction and the calibration that they come from change together.
  const std::vector<std::vector<std::string>> steps = {
      {"mask"}, {"stripes"}, {"indexing"}, {"sheets", "correction"}, {"fusion"}};
  for (const auto& step : steps) {
    std::string name;
    for (const std::string& stage : step) {
      const std::string ours = Get(stage);
      bool is_classic = false;
      for (const auto& [classic_stage, value] : kClassic)
        is_classic |= classic_stage == stage && value == ours;
      if (is_classic) continue;
      Set(stage, ours, &rung.options);
      name += (name.empty() ? "+ " : ", ") + stage + " " + ours;
    }
    if (name.empty()) continue;
    rung.name = name;
    if (step.front() == "indexing" || step.front() == "sheets") rung.calibration = calibration;
    ladder.push_back(rung);
  }
  return ladder;
}

}  // namespace dorsum::accuracy
