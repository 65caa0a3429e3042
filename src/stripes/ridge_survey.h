// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "stripes/profile_fit.h"
#include "stripes/ridge_detection.h"
#include "stripes/stripes.h"

namespace dorsum {

// The rows that the survey of a scan looks at.
inline constexpr RowComb kSurveyedRows{.first = 4, .step = 8};

// What an image says about its stripes before they are looked for one by one.
struct RidgeSurvey {
  NoiseModel noise;
  double width_px = 0.0;            // usual standard deviation of the profiles, px; 0: there are no stripes
  std::vector<StripePoint> points;  // of the surveyed rows, by row and column; only u, v and sd_px are set
};

// Where the fit of the i-th candidate of a row begins: its window ends halfway to its neighbours.
ProfileStart StartBetween(const std::vector<RidgeCandidate>& row, std::size_t i, double width_px, int cols);

// Finds stripes in the surveyed rows, fits their profiles, and takes the median width and the variance of the
// residuals against the grey value: first in some of the rows with a filter of a guessed width, then in all
// with one of theirs. With `width_px` above 0, the width is given. `green` and `region` as in FindRidges.
RidgeSurvey SurveyRidges(const cv::Mat& green, const cv::Mat& region, double width_px,
                         const RidgeDetectionOptions& detection, const ProfileFitOptions& fit,
                         const Context& context, const RowComb& rows = kSurveyedRows);

}  // namespace dorsum
