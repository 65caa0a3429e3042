// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

// A stripe's brightness over that of the picture under the LEDs, at one place.
struct RatioSample {
  float u = 0.0F, v = 0.0F;  // px
  float ratio = 0.0F;        // natural logarithm, the stripe's own strength taken out
  float level = 0.0F;        // natural logarithm of the picture's grey value
};

// How the ratio changes near a place.
struct RatioSlope {
  double along_u = 0.0;   // per px
  double of_level = 0.0;  // per unit of the picture's logarithm, at least -1
};

// Local regression of the ratio, linear in the place and in the picture's logarithm, over square cells of the
// picture.
class BrightnessRatio {
 public:
  BrightnessRatio() = default;
  // `size`: of the picture; `window_px`: a neighbour's weight falls with the distance like a Gaussian of this
  // standard deviation.
  BrightnessRatio(cv::Size size, const std::vector<RatioSample>& samples, double window_px,
                  const Context& context);

  // The slope of the place's cell. `level`: the picture's logarithm there. Zero where no sample is near.
  RatioSlope At(double u, double v, double level) const;

 private:
  RatioSlope Fit(int cell_x, int cell_y, float level) const;

  int reach_ = 0;     // of the window, in cells
  cv::Mat1f window_;  // weights of the cells in it; whole lanes, the last filled up with 0
  cv::Size cells_;
  cv::Mat1f ratio_, level_, weight_;  // means of the cells' samples, and their number; `reach_` before them
  std::vector<RatioSlope> with_samples_;  // of all cells, known where they have samples
};

}  // namespace dorsum
