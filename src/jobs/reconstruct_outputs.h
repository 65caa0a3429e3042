// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "jobs/reconstruct.h"

namespace dorsum {

inline constexpr const char* kReportJson = "report.json";
inline constexpr const char* kStageFolder = "stages";  // below the output folder

// A calibration file, read once for any number of captures.
struct LoadedCalibration {
  ReadyCalibration ready;
  std::string sha256;       // of the file, hex
  std::vector<int> lasers;  // that it knows
};

// All that decides a reconstruction besides the capture, as report.json holds it: program, calibration,
// stages and options.
Json RecipeOf(const ReconstructRequest& request, const LoadedCalibration& calibration);

// Writes DESIGN §4's outputs of one capture into a folder.
Status WriteReconstruction(const std::filesystem::path& dir, const ReconstructRequest& request,
                           const Reconstruction& result, const CaptureImages& capture,
                           const LoadedCalibration& calibration, const Context& context);

// Removes from `dir` what an earlier run with other options wrote there and this one (`written`, relative
// paths) did not: it belongs to another surface.
void RemoveEarlierFiles(const std::filesystem::path& dir, const std::vector<std::string>& written);

}  // namespace dorsum
