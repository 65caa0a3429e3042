// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "captures/device_description.h"
#include "geometry/camera.h"
#include "geometry/light_sheet.h"
#include "geometry/rigid3.h"

namespace dorsum {

// The device as its description means it, in the frame of the design (z up from the backplane, x across the
// stripes): where the parts really sit is for calibration to find.

// A camera at `position` that looks at `target`, its rows as level as that allows along the design's x.
Rigid3 LookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target);

Camera DesignedCamera(const CameraDesign& design);

// The fan spreads along the design's y, its orders along x.
DiffractedFan DesignedFan(const LaserDesign& laser, const GratingDesign& grating);

}  // namespace dorsum
