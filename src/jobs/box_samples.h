// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/correction_fit.h"
#include "captures/calibration_series.h"
#include "jobs/calibrate.h"
#include "jobs/reconstruct.h"

namespace dorsum {

using SamplesByLaser = std::map<int, std::vector<HeightSample>>;

// Points of a series' boxes for the fit of the correction (3.6), by laser. `must`: a box that the document's
// way cannot reconstruct is an error; else it is a warning and left out.
Result<SamplesByLaser> SampleBoxes(const CalibrationSeries& series, const ReadyCalibration& ready,
                                   const CalibrateOptions& options, const Context& context, bool must,
                                   std::vector<std::string>* warnings);

}  // namespace dorsum
