// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "calibration/bundle_calibration.h"
#include "calibration/classic_calibration.h"
#include "calibration/correction_fit.h"
#include "calibration/verdict.h"
#include "report/evaluation_table.h"

namespace dorsum {

// One laser's points on the boxes, and what was fitted to them.
struct LaserCorrection {
  int laser = 0;
  std::vector<HeightSample> samples;
  CorrectionFit fit;
};

// What is known of one calibration. Anything may be empty; the report then leaves it out.
struct CalibrationReportData {
  std::string title = "Calibration";
  std::string method;  // "bundle", "classic"
  ClassicCalibration classic;
  std::vector<SheetResidual> residuals;  // of the cones
  std::vector<LaserCorrection> correction;
  std::vector<PartReport> parts;          // all parts with grades, the correction among them
  std::vector<EvaluationRow> evaluation;  // on the boxes, if it was done
  std::vector<std::string> warnings;
  std::vector<ReportRow> settings;
  std::size_t sources = 0;  // files that the calibration was made from
  cv::Mat board_photo;      // chess00, BGR
  cv::Size board_inner;     // inner corners of the board; empty: no reprojection is drawn
  double square_mm = 0.0;
  std::vector<cv::Mat> background_photos;  // stripesBg by laser number; an empty Mat for a missing one
  std::string version;                     // of the program
};

// The page of a calibration, self-contained. Holds no date: the same data give the same bytes.
std::string MakeCalibrationReport(const CalibrationReportData& data);

}  // namespace dorsum
