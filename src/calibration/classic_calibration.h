// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/background_model.h"
#include "calibration/camera_calibration.h"
#include "calibration/first_estimates.h"
#include "calibration/grating_height.h"
#include "calibration/stripe_spacing.h"
#include "captures/calibration_series.h"
#include "geometry/calibration.h"

namespace dorsum {

struct ClassicCalibrationOptions {
  CameraCalibrationOptions camera;
  StripeSpacingOptions spacing;
  FirstEstimatesOptions first_estimates;
  BackgroundModelOptions background;
};

// All that was seen and found of one laser.
struct LaserCalibration {
  int laser = 0;
  PlaneStripes further, closer;
  GratingHeight grating;
  double first_estimate_mm = 0.0;  // world x of the drawn line
  double central_x_mm = 0.0;       // world x of the central stripe at y = 0
  BackgroundModel background;
  PartReport report;
};

struct ClassicCalibration {
  CameraCalibration camera;  // in the final world frame
  std::vector<LaserCalibration> lasers;
  DeviceGeometry device;  // plane sheets, no correction yet
  std::vector<std::string> warnings;
};

// The document's calibration (§3.2) up to the reference stripes: camera, world, grating heights (3.4),
// central stripes and x offsets, background model, and one plane per order. The world is aligned as DESIGN §2
// says. The surface error correction, which needs a reconstruction, comes after it (jobs/calibrate).
Result<ClassicCalibration> CalibrateClassic(const CalibrationSeries& series,
                                            const ClassicCalibrationOptions& options, const Context& context);

// The same for a camera whose world is aligned already, as the bundle leaves it: the camera stays as it is.
// `drawn`, if they were looked for before, are the lines of laserFirstEstimates.
Result<ClassicCalibration> CalibrateClassicLasers(const CalibrationSeries& series,
                                                  const CameraCalibration& camera,
                                                  const ClassicCalibrationOptions& options,
                                                  const Context& context,
                                                  std::optional<DrawnLines> drawn = std::nullopt);

}  // namespace dorsum
