// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

struct MotionOptions {
  int tile_px = 48;         // side of the squares that are looked at, px, 16 to 256
  double blur_px = 1.5;     // against noise, px, 0.5 to 5
  double max_sd_px = 0.08;  // squares whose motion is known worse than this say nothing, px
  int agreeing = 3;         // squares that must have moved so far, 1 to 100
};

struct PictureMotion {
  double shift_px = 0.0;  // that the object has moved somewhere, at least; 0: it rests as far as can be seen
  int tiles = 0;          // squares that had edges to look at
};

// How far what is seen has moved between two pictures under the same light (CV_8UC3 of one size): bgHand and
// bgHandAfter. In each square that has an edge, the shift across the edge that explains the difference best
// (normal flow: Horn and Schunck 1981, equation for the component along the gradient, in least squares over
// the square), less three standard deviations. A shift of more than the blur comes out too small, but not as
// rest.
PictureMotion MeasureMotion(const cv::Mat& before, const cv::Mat& after, const MotionOptions& options = {});

}  // namespace dorsum
