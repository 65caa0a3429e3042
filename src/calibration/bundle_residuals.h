// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "calibration/bundle_calibration.h"
#include "calibration/sheet_assignment.h"
#include "calibration/sheet_pictures.h"

namespace dorsum {

// What each stripe point leaves unexplained by the solution; `c` holds data, solution and device.
std::vector<SheetResidual> Residuals(const BundleCalibration& c);

// Share of each picture's stripe points that fit an order.
std::vector<double> AssignedShares(const std::vector<SheetPicture>& pictures,
                                   const std::vector<SheetPoint>& points,
                                   const SheetAssignmentOptions& options);

}  // namespace dorsum
