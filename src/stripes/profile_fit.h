// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stripes/noise_model.h"

namespace dorsum {

struct ProfileFitOptions {
  double half_window_sd = 3.0;  // half the window, in standard deviations of the profile, 2 to 5
  int saturated_grey = 250;     // pixels from here on count as "at least this", grey values, 1 to 255
  int max_iterations = 12;
  double min_width_px = 0.5, max_width_px = 16.0;  // profile's standard deviation, px
};

// Where to begin and where to end: the window never reaches beyond [first, last].
struct ProfileStart {
  double u = 0.0, width = 2.0;  // px
  int first = 0, last = 0;      // columns
  bool hold_width = false;      // the centre may then lie a width outside [first, last]
  // How bright the surface is in every column from `first` on, 0: not seen there; null: alike everywhere.
  const float* gain = nullptr;
  // What the amplitude is expected to be, and its standard deviation, grey values; 0: nothing is known.
  double amplitude = 0.0, amplitude_sd = 0.0;

  float GainAt(int column) const { return gain == nullptr ? 1.0F : gain[column - first]; }
};

// A Gaussian on an even background, in one row of an image; with a gain, times that.
struct ProfileFit {
  bool ok = false;
  bool width_held = false;  // the row does not fix the width; the start's stands
  double u = 0.0;           // px
  double width = 0.0;       // px, one standard deviation
  double amplitude = 0.0;   // above the background, grey values; a clipped top is completed
  double background = 0.0;  // grey values
  double sd_u = 0.0;        // px, formal, of the noise model
  int first = 0, last = 0;  // columns used
  int clipped = 0;          // pixels in the window at or above saturated_grey

  double At(double column) const;  // without gain
};

// Where the fit begins: the window, the extremes in it, and how many pixels saturate. Returns the number of
// pixels where the surface is seen. The window has at most kMostHalfWindow columns on each side.
inline constexpr int kMostHalfWindow = 127;
int BeginFit(const std::uint8_t* row, const ProfileStart& start, const ProfileFitOptions& options,
             ProfileFit* fit);

// A profile to be fitted in a row of an image.
struct ProfileTask {
  const std::uint8_t* row = nullptr;
  ProfileStart start;
};

// Weighted least squares of centre, width, amplitude and background (Levenberg-Marquardt) with the noise
// model's variances, so that the centre's spread meets the Cramér-Rao bound with all four unknown. Clipped
// pixels are censored: they only speak where the model stays below them. One fit per task, each the same
// whatever the others are.
std::vector<ProfileFit> FitProfiles(std::span<const ProfileTask> tasks, const NoiseModel& noise,
                                    const ProfileFitOptions& options);

ProfileFit FitProfile(const std::uint8_t* row, const ProfileStart& start, const NoiseModel& noise,
                      const ProfileFitOptions& options);

}  // namespace dorsum
