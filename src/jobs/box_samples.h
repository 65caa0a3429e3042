// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/bundle_calibration.h"
#include "calibration/correction_fit.h"
#include "captures/calibration_series.h"
#include "jobs/calibrate.h"
#include "jobs/reconstruct.h"

namespace dorsum {

using SamplesByLaser = std::map<int, std::vector<HeightSample>>;

// Points of a series' boxes for the fit of the correction (3.6), by laser, reconstructed by the document's
// way. A box that this cannot reconstruct is an error.
Result<SamplesByLaser> SampleBoxes(const CalibrationSeries& series, const ReadyCalibration& ready,
                                   const CalibrateOptions& options, const Context& context,
                                   std::vector<std::string>* warnings);

// The same from the stripes that a bundle has found on the boxes. `device` has the plane sheets besides the
// bundle's cones, with the same orders.
SamplesByLaser SampleBundle(const BundleCalibration& bundle, const DeviceGeometry& device);

}  // namespace dorsum
