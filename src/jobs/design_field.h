// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "jobs/design_point.h"

namespace dorsum {

// One laser along x, in the middle of the hand area, on a level surface.
struct FieldSample {
  double x_mm = 0.0;
  double order = 0.0;
  bool used = false;  // lit and seen
  double spacing_mm = 0.0, spacing_px = 0.0;
  double depth_mm_per_px = 0.0;
  double width_px = 0.0;                             // of the stripe, one standard deviation
  double peak = 0.0;                                 // of the stripe in the picture, 1: full scale
  double row_sigma_mm = 0.0, pooled_sigma_mm = 0.0;  // of z, from one image row and from pooled ones
};
std::vector<FieldSample> SampleField(const DesignedDevice& device, int laser, double height_mm,
                                     const SurfaceAssumption& surface, int count = 61);

// One laser, or all of them, over the hand area and the working volume.
struct VolumeFigures {
  double used = 0.0;  // share of the volume over the hand area that is lit and seen
  double least_depth_mm_per_px = 0.0, middle_depth_mm_per_px = 0.0, most_depth_mm_per_px = 0.0;
  double spacing_low_mm = 0.0, spacing_low_px = 0.0;    // on the backplane, mean
  double spacing_high_mm = 0.0, spacing_high_px = 0.0;  // at the volume's top
  double row_sigma_mm = 0.0, pooled_sigma_mm = 0.0;     // root mean square over what is used
  double row_sigma_px = 0.0;
  double dimmest_peak = 0.0, brightest_peak = 0.0;
  double saturated = 0.0;       // share of what is used where the stripe reaches full scale
  double narrowest = 0.0;       // spacing over the stripe's width, least
  double points_per_cm2 = 0.0;  // image rows times stripes, mean
};
// At `heights` levels of a grid of columns x rows.
VolumeFigures JudgeVolume(const DesignedDevice& device, int laser, const SurfaceAssumption& surface,
                          int columns = 13, int rows = 7, int heights = 5);

}  // namespace dorsum
