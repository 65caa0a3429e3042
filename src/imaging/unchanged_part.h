// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

// The picture under the LEDs beside that of the empty backplane, in squares of a few pixels, whose mean has
// little noise. Both in colour (CV_8UC3) or their green alone (CV_8UC1), of one size.
class UnchangedPart {
 public:
  UnchangedPart(const cv::Mat& background, const cv::Mat& hand, const Context& context = {});

  // How much of the pictures is as Mask() says, 0 to 1.
  double Share(double share) const;

  // CV_8UC1 of the pictures' size: 255 where the light is what it was, but for this share of it; 0 in the
  // last columns and rows that fill no square.
  cv::Mat Mask(double share, const Context& context = {}) const;

 private:
  cv::Mat Unchanged(double share) const;  // by square

  cv::Size size_;
  cv::Mat before_, difference_;
};

}  // namespace dorsum
