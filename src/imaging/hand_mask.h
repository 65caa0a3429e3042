// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"

namespace dorsum {

struct HandMaskOptions {
  int open_px = 7;                // side of the square of the opening, px; odd, 1 to 99
  double min_area_share = 0.005;  // smallest object, as a share of the image, 0 to 1
  double max_area_share = 0.9;    // largest, 0 to 1
  double min_contrast =
      40.0;  // least distance between the means of object and background, 255ths of the background
};

struct HandMask {
  cv::Mat mask;            // CV_8UC1, 0 or 255, the captured image's size
  double threshold = 0.0;  // grey values
  double area_share = 0.0;
  double contradicting = 0.0;  // share of seeds on the wrong side of the outline; RefineObjectMask fills it
};

// The document's mask of hand or object (§3.4, Figure 3.4): the background is subtracted, the difference
// thresholded by the iterative algorithm of §2.2, and the result opened. Only the largest region is kept.
// `background` and `hand` are CV_8UC3 of one size. An error when no object stands out.
Result<HandMask> ExtractHandMask(const cv::Mat& background, const cv::Mat& hand,
                                 const HandMaskOptions& options, const Context& context = {});

}  // namespace dorsum
