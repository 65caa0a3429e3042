// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

struct CandidateRegionOptions {
  double changed = 0.06;      // change of the light's root that counts as changed, 0 to 1
  double strong = 0.15;       // and as an object that stands out, 0 to 1
  double strong_share = 0.4;  // least share of the region that stands out, 0 to 1; else the whole image
  int margin_px = 60;         // around all that has changed, px, 0 up
};

// Where stripes of the object and of the backplane around it are to be looked for: the convex hull of all
// that has changed under the LEDs, shadow included, with a margin. It never cuts the object off: where little
// of the hull stands out (a white object, of which only the shadow is seen, or a lamp that changed) it is the
// whole image. `background` and `hand` are CV_8UC3 of one size. Returns CV_8UC1, 0 or 255.
cv::Mat CandidateRegion(const cv::Mat& background, const cv::Mat& hand,
                        const CandidateRegionOptions& options);

}  // namespace dorsum
