// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "base/json.h"
#include "base/result.h"

namespace dorsum {

// What is known before calibrating: setup.json of a calibration folder (DESIGN §4).
struct Setup {
  int board_columns = 0, board_rows = 0;  // inner corners of the chessboard
  double square_mm = 0.0;
  double calibration_object_height_mm = 0.0;  // h of equation 3.4
  std::vector<double> box_heights_mm;         // boxes under heights/
  double grating_lines_per_mm = 0.0;
  double wavelength_nm = 0.0;
  int width = 0, height = 0;  // camera resolution, px
};

Result<Setup> ReadSetup(const std::filesystem::path& calibration_dir);
Json SetupToJson(const Setup& setup);

}  // namespace dorsum
