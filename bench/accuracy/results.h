// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "accuracy/score.h"
#include "base/json.h"
#include "base/result.h"
#include "jobs/evaluate.h"

namespace dorsum::accuracy {

struct CaptureResult {
  std::string name;     // of its folder
  std::string refused;  // the product's sentence, when it gave no surface
  std::vector<std::string> warnings;
  Figures figures;                  // accuracy/score.h's, and radius_error, mm, of spheres and cylinders
  Figures budget;                   // accuracy/budget.h's, on the rungs that have one
  std::vector<ModelErrors> models;  // of boxes: §5.1, each laser and merged
};

// All captures of one true device, reconstructed in one way.
struct DeviceResult {
  std::string design, seed, rung;
  std::string refused;  // calibration's sentence, when there is none
  Figures figures;      // of the calibration
  std::vector<CaptureResult> captures;
  std::vector<RepeatDifference> repeats;  // (5.2) between captures of the same box
};

struct Results {
  std::string version;  // of the program
  std::vector<DeviceResult> devices;
};

Json ResultsToJson(const Results& results);
Result<Results> ReadResults(const std::filesystem::path& path);

}  // namespace dorsum::accuracy
