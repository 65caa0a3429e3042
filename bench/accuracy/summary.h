// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "accuracy/results.h"
#include "accuracy/scene_kind.h"

namespace dorsum::accuracy {

// A figure of every capture of one kind, on all devices of a design, one way of reconstructing.
struct Collected {
  int captures = 0, refused = 0;
  std::map<std::string, std::vector<double>> figures, budget;
};

// Of figures that tables judge but single captures do not have: z_rmse_laser is the worst laser's z_rmse;
// repeat_difference the merged RMSE's difference (5.2) of each pair of repeats.
Collected Collect(const Results& results, const std::string& design, const std::string& rung, SceneKind kind);

// Figures of the calibrations of a design's devices; `captures` counts devices.
Collected CollectDevices(const Results& results, const std::string& design, const std::string& rung);

// Designs and rungs in the order in which they were run.
std::vector<std::string> DesignsOf(const Results& results);
std::vector<std::string> RungsOf(const Results& results, const std::string& design);

}  // namespace dorsum::accuracy
