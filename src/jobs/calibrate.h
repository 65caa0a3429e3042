// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/bundle_calibration.h"
#include "calibration/calibration_file.h"
#include "calibration/classic_calibration.h"
#include "report/calibration_report.h"

namespace dorsum {

struct CalibrateOptions {
  std::string method = "bundle";  // bundle | classic
  BundleOptions bundle;
  ClassicCalibrationOptions classic;
  std::size_t samples_per_laser_and_box = 4000;  // at most, for the fit of the correction
};

// A calibration and all that was seen on the way, for the report.
struct CalibrationRun {
  Calibration calibration;
  std::optional<BundleCalibration> bundle;
  ClassicCalibration classic;
  std::vector<LaserCorrection> correction;  // by laser (Figure 4.3)
  std::vector<std::string> files;           // written
};

Result<CalibrationRun> CalibrateSeries(const CalibrationSeries& series, const CalibrateOptions& options,
                                       const Context& context);

// The job behind `dorsum calibrate`: writes calibration.json and, beside it, a report of the same name with
// .html. Nothing is written unless all is well.
Result<CalibrationRun> CalibrateFolder(const std::filesystem::path& dir, const std::filesystem::path& out,
                                       const CalibrateOptions& options, const Context& context);

}  // namespace dorsum
