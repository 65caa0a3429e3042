// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/calibration.h"
#include "simulator/virtual_device.h"

namespace dorsum {

struct SheetErrorOptions {
  double min_height_mm = 0.0, max_height_mm = 80.0;
  double height_step_mm = 10.0;
  double row_step_px = 40.0;  // along a stripe
};

// Errors of heights that calibrated light sheets alone cause, mm.
struct SheetError {
  int laser = 0;
  double rms_mm = 0.0, mean_mm = 0.0, worst_mm = 0.0;
  std::size_t points = 0;
  std::size_t lost = 0;  // rays that miss the calibrated sheet
};

// For every order, a grid of heights and all rows of the image: where the true sheet meets the true camera's
// ray at that height, and which height the calibrated camera and sheet give the same pixel. Both live in the
// world frame of DESIGN §2, so heights compare directly. One entry per laser of `device` that is true as
// well.
std::vector<SheetError> MeasureSheetError(const DeviceGeometry& device, const Camera& true_camera,
                                          const std::vector<DiffractedFan>& true_fans,
                                          const std::vector<int>& true_orders,
                                          const SheetErrorOptions& options = {});
std::vector<SheetError> MeasureSheetError(const DeviceGeometry& device, const VirtualDevice& truth,
                                          const SheetErrorOptions& options = {});

}  // namespace dorsum
