// SPDX-License-Identifier: Apache-2.0
#include "accuracy/rungs.h"

#include "jobs/calibrate.h"

namespace dorsum::accuracy {
namespace {

ReconstructOptions Stages(const std::string& method) {
  ReconstructOptions options;
  options.method = method;
  return ResolveStages(options);
}

}  // namespace

std::vector<Rung> Ladder() {
  const ReconstructOptions ours = Stages("default");
  Rung rung{"classic", "classic", Stages("classic")};
  std::vector<Rung> ladder = {rung};
  const auto step = [&](const std::string& name, bool changed) {
    if (!changed) return;
    rung.name = "+ " + name;
    ladder.push_back(rung);
  };
  const auto take = [](std::string* stage, const std::string& value) {
    const bool changed = *stage != value;
    *stage = value;
    return changed;
  };
  ReconstructOptions& o = rung.options;
  // Our calibration holds the planes too, so the other stages can follow one by one.
  const std::string calibration = CalibrateOptions{}.method;
  step("calibration " + calibration, take(&rung.calibration, calibration));
  step("stripes " + ours.stripes, take(&o.stripes, ours.stripes));
  step("indexing " + ours.indexing, take(&o.indexing, ours.indexing));
  const bool corrected = take(&o.correction, ours.correction);
  step("sheets " + ours.sheets, take(&o.sheets, ours.sheets) || corrected);
  // The mask comes late: it is cut from stripes whose orders and places are known.
  step("mask " + ours.mask, take(&o.mask, ours.mask));
  step("shading " + ours.shading, take(&o.shading, ours.shading));
  step("fusion " + ours.fusion, take(&o.fusion, ours.fusion));
  if (ladder.size() > 1) ladder.back().name += " (default)";
  return ladder;
}

}  // namespace dorsum::accuracy
