// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/bundle_checks.h"
#include "calibration/bundle_problem.h"
#include "calibration/camera_calibration.h"
#include "calibration/first_estimates.h"
#include "calibration/sheet_assignment.h"
#include "calibration/sheet_pictures.h"
#include "calibration/sheet_start.h"
#include "calibration/verdict.h"
#include "captures/calibration_series.h"
#include "geometry/calibration.h"

namespace dorsum {

struct BundleVerdictOptions {
  double good_rms_px = 0.35;     // reprojection error up to which the camera is good
  double doubtful_rms_px = 1.0;  // and up to which it is merely doubtful
  double height_off_mm = 0.3;    // how far a given height may be off what fits, mm, ...
  double significant = 5.0;      // ... and in standard deviations
  double board_sag_mm = 0.15;    // how much a board may sag at its corners, mm
  double moved_mm = 0.08;        // how far a series may lie off what the others predict, mm on the plane
  double assigned_share = 0.35;  // least share of a picture's stripes that must fit an order
  double pattern_mm = 0.03;      // pattern along stripes and over orders that the model may leave, mm
};

struct BundleOptions {
  SheetPictureOptions pictures;
  SheetStartOptions start;
  SheetAssignmentOptions assignment;
  BundleProblemOptions problem;
  FirstEstimatesOptions first_estimates;
  BundleVerdictOptions verdicts;
};

// What one stripe point leaves unexplained.
struct SheetResidual {
  int laser = 0, order = 0;
  int picture = 0;         // index into BundleCalibration::pictures
  double height_mm = 0.0;  // of its plane, as given
  double x_mm = 0.0, y_mm = 0.0;
  double miss_mm = 0.0;        // on the plane, towards growing order
  double sd_mm = 0.0;          // that it was weighed with
  double height_per_mm = 0.0;  // how much height goes with 1 mm of that
};

struct BundleCalibration {
  CameraCalibration start;            // what the chessboards alone say of the camera
  DeviceGeometry device;              // cone sheets, in the world frame of DESIGN §2
  std::optional<DrawnLines> drawn;    // of laserFirstEstimates, if it shows any
  BundleData data;                    // what was adjusted
  BundleSolution solution;            // in the same world
  std::vector<std::string> pictures;  // names, of SheetResidual::picture
  std::vector<int> laser_of_picture;  // index of the laser
  std::vector<SheetResidual> residuals;
  std::vector<double> view_rms_px;  // reprojection error of each board view
  BoardCheck board;
  std::vector<HeightCheck> heights;
  std::vector<SeriesCheck> series;    // of the first solution, in which no picture was left out
  std::vector<SeriesCheck> left_out;  // pictures that contradict the others and were left out
  std::vector<double> assigned;       // share of the stripe points of each picture that fit an order
  std::vector<double> pattern_mm;     // that each laser's sheets leave (LeftPattern)
  std::vector<PartReport> parts;
  std::vector<std::string> warnings;
};

// Cone calibration (DESIGN §3): lens, camera pose, board poses and, per laser, the grating's pose, tilt,
// order step and fan distance in one robust least squares over chessboard corners and the stripes on every
// plane of known height.
Result<BundleCalibration> CalibrateBundle(const CalibrationSeries& series,
                                          const CameraCalibrationOptions& camera,
                                          const BundleOptions& options, const Context& context);

}  // namespace dorsum
