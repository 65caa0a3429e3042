// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "geometry/camera.h"
#include "geometry/light_sheet.h"
#include "stripes/stripes.h"

namespace dorsum {

struct SheetStartOptions {
  double band_mm = 25.0;       // stripes are looked at within this distance of y = 0, mm
  double weak_share = 0.2;     // stripes dimmer than this share of the usual one may be ghosts, 0 to 1
  double tilt_sd = 0.07;       // how far a fan leans in a device, sine
  double usual_miss_mm = 0.4;  // of a stripe, mm
  int min_lines = 3;           // fewest stripes on each plane
};

// A stripe near y = 0 on a plane: x = at + slope * y, mm.
struct StripeLine {
  double at = 0.0, slope = 0.0;
  double strength = 0.0;  // its usual brightness, grey values
  double rows = 0.0;
};

// Stripes on the plane z = z_mm, by growing x.
std::vector<StripeLine> LinesOnPlane(const Camera& camera, const LaserStripes& stripes, double z_mm,
                                     const SheetStartOptions& options);

struct SheetStart {
  DiffractedFan fan;
  double rms_mm = 0.0;    // what is left on the two planes
  int central_shift = 0;  // by how many stripes the brightest one on the nearer plane was not the same order
  int far_lines = 0, near_lines = 0;
};

// First estimate of one laser's sheets from where its stripes cross y = 0 on two planes, whatever the
// device's design: lines through the grating, x_m(z) = g_x + (g_z - z) tan(asin(alpha + m step)), by least
// squares over both planes. Orders count from the brightest stripe, or from the one nearest to `central_x_mm`
// if it is given; which stripe is the same one on the other plane is tried and the best kept.
Result<SheetStart> EstimateSheets(const Camera& camera, const LaserStripes& far, const LaserStripes& near,
                                  double near_z_mm, std::optional<double> central_x_mm,
                                  const SheetStartOptions& options);

}  // namespace dorsum
