// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"
#include "captures/jpeg_image.h"
#include "captures/kept_pictures.h"
#include "captures/setup.h"

namespace dorsum {

// A checked calibration folder (§3.2, DESIGN §4). Images are read when they are needed, by their names.
struct CalibrationSeries {
  std::filesystem::path dir;
  Setup setup;
  std::vector<int> lasers;               // lasers whose images are all there, ascending
  std::vector<std::string> chess_views;  // names of the chessboard views present
  std::vector<double> box_heights_mm;    // those of setup.json whose folder is there
  std::vector<std::string> warnings;     // one sentence each
  std::shared_ptr<KeptPictures> kept;    // null: none

  // The same series, which decodes only once what both methods of calibration look at. What Read() gives is
  // then shared: nobody may write to it.
  CalibrationSeries KeepingPictures() const;

  // An image of the series, of the resolution that setup.json says.
  Result<cv::Mat> Read(const std::string& name, Channels channels = Channels::kBgr) const;
  std::filesystem::path BoxDir(double height_mm) const;
  // Every file of the series that exists, for the record of what a calibration was made from.
  std::vector<std::filesystem::path> Files() const;
};

// Looks at every file by name; a file that the method cannot do without is an error, one that it can is a
// warning.
Result<CalibrationSeries> LoadCalibrationSeries(const std::filesystem::path& dir);

}  // namespace dorsum
