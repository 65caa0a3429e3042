// SPDX-License-Identifier: Apache-2.0
#include "captures/setup.h"

#include <algorithm>
#include <cmath>

#include "captures/names.h"

namespace dorsum {
namespace {

bool AllWhole(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return v == std::floor(v); });
}

}  // namespace

Result<Setup> ReadSetup(const std::filesystem::path& calibration_dir) {
  const std::filesystem::path path = calibration_dir / kSetupName;
  std::error_code ec;
  if (!std::filesystem::exists(path, ec)) {
    return BadInput("there is no setup.json in " + calibration_dir.string() +
                    "; it says what the chessboard and the boxes measure");
  }
  DORSUM_ASSIGN_OR_RETURN(const Json json, ReadJson(path));
  JsonReader reader(json, path.string());
  JsonReader board(reader.Object("chessboard"), path.string() + ", chessboard");
  DORSUM_RETURN_IF_ERROR(reader.status());
  const std::vector<double> corners = board.Numbers("inner_corners", 2, 3, 100);
  if (!AllWhole(corners)) board.Fail("inner_corners", "must be whole numbers");
  Setup s;
  s.board_columns = static_cast<int>(corners[0]);
  s.board_rows = static_cast<int>(corners[1]);
  s.square_mm = board.Number("square_mm", 0.1, 1000.0);
  DORSUM_RETURN_IF_ERROR(board.status());
  s.calibration_object_height_mm = reader.Number("calibration_object_height_mm", 0.1, 1000.0);
  s.box_heights_mm = reader.Numbers("box_heights_mm", -1, 0.1, 1000.0);
  s.grating_lines_per_mm = reader.Number("grating_lines_per_mm", 0.1, 10000.0);
  s.wavelength_nm = reader.Number("wavelength_nm", 300.0, 1100.0);
  const std::vector<double> size = reader.Numbers("camera_resolution", 2, 16, 20000);
  if (!AllWhole(size)) reader.Fail("camera_resolution", "must be whole numbers");
  DORSUM_RETURN_IF_ERROR(reader.status());
  s.width = static_cast<int>(size[0]);
  s.height = static_cast<int>(size[1]);
  return s;
}

Json SetupToJson(const Setup& s) {
  return Json{
      {"chessboard", {{"inner_corners", {s.board_columns, s.board_rows}}, {"square_mm", s.square_mm}}},
      {"calibration_object_height_mm", s.calibration_object_height_mm},
      {"box_heights_mm", s.box_heights_mm},
      {"grating_lines_per_mm", s.grating_lines_per_mm},
      {"wavelength_nm", s.wavelength_nm},
      {"camera_resolution", {s.width, s.height}}};
}

}  // namespace dorsum
