// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "stripes/noise_model.h"
#include "stripes/profile_fit.h"
#include "stripes/stripes.h"
#include "stripes/surface_brightness.h"

namespace dorsum {

struct ShadedRowOptions {
  double dark_side = 0.4;  // a centre is beyond an edge where the surface within `edge_px` of it is darker
                           // than this share of what lies within 1.5 widths, 0 to 1
  double edge_px = 1.0;    // half a pixel for the edge and half a pixel for the centre, px, 0 to 5
  double cut = 0.6;  // a row is cut where its darkest column within 1.5 widths has less than this share of
                     // the brightest, 0 to 1
  double max_move = 1.2;  // a centre that moves further than this many widths is left as it was, 0 to 3
  double max_sd = 0.35;   // a centre that is known no better than this many widths is no measurement, 0 to 3
};

// A laser's picture, CV_8UC1, and its noise.
struct LaserPicture {
  cv::Mat green;
  NoiseModel noise;
};

// One row of a stripe, fitted on a surface whose brightness is known.
struct ShadedRow {
  ProfileFit profile;
  bool moved = false;              // the profile's centre is better than the measured one
  bool measures = true;            // the surface: the centre is known, and not beyond an edge
  bool cut = false;                // an edge or the outline lies within the stripe
  std::optional<double> strength;  // natural logarithm of the amplitude over the surface's brightness
};

// What the whole rows around a cut one say of it.
struct WholeRows {
  double strength = 0.0, share = 0.0;  // of the amplitude; standard deviation as a share of it
  double width = 0.0;                  // px
};

// The median of the nearest whole rows of a stripe's segment; none where these are too few.
std::optional<WholeRows> WholeRowsAround(const std::vector<ShadedRow>& rows, std::size_t at);

// A stripe point whose row is to be fitted. `width`: usual around there, px. With one flank gone, the
// amplitude, width and centre of a row cannot be told from each other, and the centre is drawn to the flank
// that is left; `whole` fixes the other two.
struct ShadedRowTask {
  StripePoint point;
  double width = 0.0;
  std::optional<WholeRows> whole;
};

// Fits rows of one laser's picture. `columns`: of all stripe points of each row, growing; a window does not
// reach beyond half the way to the next.
std::vector<ShadedRow> FitShadedRows(const std::vector<ShadedRowTask>& tasks,
                                     const SurfaceBrightness& brightness, const LaserPicture& picture,
                                     const std::vector<std::vector<float>>& columns,
                                     const ProfileFitOptions& fit, const ShadedRowOptions& options);

}  // namespace dorsum
