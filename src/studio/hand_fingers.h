// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// Where the palm lies in a hand's mask: the largest circle that fits into it.
struct Palm {
  cv::Point centre;        // px
  double radius_px = 0.0;  // 0: there is no hand
};

// A hand's mask (CV_8UC1, not 0 on the hand) in parts.
struct HandParts {
  Palm palm;
  // One part for each finger that stands alone, CV_8UC1 of the mask's size. Ordered clockwise in the picture
  // around the palm, from the arm on: as a person sees the back of the own hand, from left to right.
  std::vector<cv::Mat> fingers;
};

// What is left of the hand when all is taken away that a circle of 0.42 of the palm's radius fits into, as
// far as it is as long as a finger and does not lie on the side where the arm comes in. Fingers that touch
// make one part, or none. The mask should be about 300 to 600 px wide: time grows with the palm's radius.
HandParts FindFingers(const cv::Mat& mask);

}  // namespace dorsum
