// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "captures/device_description.h"

namespace dorsum {

// One image row across a stripe, in light: 1 is the sensor's full scale.
struct StripeProfile {
  double core_peak = 0.5, core_sigma_px = 2.0;  // above the background
  double wide_peak = 0.0, wide_sigma_px = 6.0;  // glow of light that wandered under skin; 0: none
  double background = 0.01;                     // daylight
};

// Standard deviations of the stripe's centre, px.
struct CentreNoise {
  double white_px = 0.0;    // photons, reading out and rounding, which every row draws anew
  double speckle_px = 0.0;  // speckle, whose grains rows share
  double row_px = 0.0;      // a single row's: both
  double saturated = 0.0;   // share of the profile's pixels at full scale, 0 to 1

  // The centre that a local quadratic through `rows` rows gives at its middle.
  double PooledPx(int rows, const SpeckleDesign& speckle) const;
};

// What least squares with weights 1 / V finds of the centre of a profile p(u) whose shape is known, where
// pixel i has variance V_i = (p_i full_well + read_noise^2) / full_well^2 + rounding + (contrast p_i)^2. With
// independent pixels that is the Cramer-Rao bound, 1 / sum(p'_i^2 / V_i); grains of speckle span pixels, so
// their part is carried through the same weights, w' C w, with C_ij = contrast^2 p_i p_j exp(-(d / (2
// sigma))^2). Pixels at full scale say nothing. Mosaic sensors have green in every second pixel only. What a
// JPEG file adds is left out.
//
// Sources: S. M. Kay, Fundamentals of Statistical Signal Processing I (1993), chapter 3, for the bound; R.
// Dorsch, G. Haeusler, J. Herrmann, Laser triangulation: fundamental uncertainty in distance measurement,
// Applied Optics 33 (1994), for speckle as what limits it.
CentreNoise StripeCentreNoise(const StripeProfile& profile, const SensorDesign& sensor,
                              const SpeckleDesign& speckle);

}  // namespace dorsum
