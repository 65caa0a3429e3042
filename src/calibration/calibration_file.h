// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/result.h"
#include "calibration/verdict.h"
#include "geometry/calibration.h"

namespace dorsum {

// A file that a calibration was made from.
struct SourceFile {
  std::string name;    // relative to the calibration folder
  std::string sha256;  // hex
};

// calibration.json (DESIGN §4): all that reconstruction needs, and what to believe of it.
struct Calibration {
  std::string method = "classic";
  DeviceGeometry device;
  std::string background;  // bgNoHand as it was captured (encoded PNG or JPEG): the mask is made against it
  std::vector<PartReport> parts;
  std::vector<std::string> warnings;
  std::vector<SourceFile> sources;
  std::string version;  // of the program that made it
};

Json CalibrationToJson(const Calibration& calibration);
Result<Calibration> CalibrationFromJson(const Json& json, const std::string& where);
Status WriteCalibration(const std::filesystem::path& path, const Calibration& calibration);
Result<Calibration> ReadCalibration(const std::filesystem::path& path);

}  // namespace dorsum
