// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "stripes/profile_fit.h"
#include "stripes/ridge_detection.h"

namespace dorsum {

// What an image says about its stripes before they are looked for one by one.
struct RidgeSurvey {
  NoiseModel noise;
  double width_px = 0.0;  // usual standard deviation of the profiles, px; 0: there are no stripes
};

// Finds stripes in every eighth row with a filter of a guessed width, fits their profiles, and takes the
// median width and the variance of the residuals against the grey value. With `width_px` above 0, the width
// is given. `green` and `region` as in FindRidges.
RidgeSurvey SurveyRidges(const cv::Mat& green, const cv::Mat& region, double width_px,
                         const RidgeDetectionOptions& detection, const ProfileFitOptions& fit,
                         const Context& context);

}  // namespace dorsum
