// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jobs/calibrate.h"

namespace dorsum {

// The bundle (calibration/bundle_calibration.h), and in its camera's world the document's sheets beside the
// cones, so that one file serves both. What the document's method cannot do on this device is a warning.
Status CalibrateByBundle(const CalibrationSeries& series, const CalibrateOptions& options,
                         const Context& context, CalibrationRun* run);

}  // namespace dorsum
