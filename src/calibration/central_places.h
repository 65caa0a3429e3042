// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "calibration/bundle_calibration.h"
#include "calibration/sheet_pictures.h"
#include "captures/calibration_series.h"
#include "geometry/camera.h"

namespace dorsum {

// The picture of that laser (its index) in a series ("backplane", "Closer", …); null if there is none.
const SheetPicture* FindPicture(const std::vector<SheetPicture>& pictures, int laser,
                                const std::string& series);

// Where each laser's central stripe lies on the backplane, x in mm, by the laser's number: which drawn line
// (§3.2) belongs to which laser is told by the lasers' brightest stripes, and where the drawing is no help
// they stand in for it, with a warning.
std::map<int, double> CentralPlaces(const CalibrationSeries& series, const Camera& camera,
                                    const std::vector<SheetPicture>& pictures,
                                    const std::optional<DrawnLines>& drawn, const BundleOptions& options,
                                    std::vector<std::string>* warnings);

}  // namespace dorsum
