// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "imaging/hand_mask.h"

namespace dorsum {

// A place in the captured image that is known to show the object or the backplane: a stripe point whose
// height was measured.
struct ObjectSeed {
  float u = 0.0F, v = 0.0F;  // px
  bool object = false;       // else the backplane
};

struct ObjectMaskOptions {
  int min_seeds = 50;  // object's seeds below which the picture under the LEDs decides alone, 1 up
  // Length of outline that a row of a stripe is worth, px, 0.1 to 2. Below 1, so that a whole stripe that is
  // on the wrong side of an outline goes when nothing in the picture speaks for it.
  double seed_strength = 0.7;
  double pull = 0.01;             // the same for one pixel's brightness, 0 to 1
  double min_area_share = 0.001;  // smallest piece of the object, as a share of the image, 0 to 1
  HandMaskOptions picture_only;   // for use without seeds
};

// What the pictures under the LEDs show before any seed is known.
struct ObjectLight {
  cv::Mat empty;            // CV_8UC1, not 0 where there is surely nothing but backplane; or no picture
  cv::Rect busy;            // around all that is not
  cv::Mat single, doubled;  // CV_32FC1: the light there (imaging/led_ratio.h), and on pixels of double size
};
// `background` and `hand` in colour or green alone.
ObjectLight FindObjectLight(const cv::Mat& background, const cv::Mat& hand, const cv::Mat& empty,
                            const Context& context = {});

// The object's mask (§3.4) from what the stripes have proved and from the picture under the LEDs. A wrong
// shadow never passes a stripe that lies on the backplane, a bright ring never parts a finger.
//   Between two neighbouring seeds of one kind in a row all is of that kind. Elsewhere the outline is the
// minimum cut (Boykov and Jolly 2001) of the picture's light, hand / background: cheap along a sharp edge of
// it, where shadow has none; a seed costs `seed_strength` when it lands on the wrong side, so that a few
// wrong ones do no harm. First on pixels of double size, then on single ones along the outline found,
// then to a part of a pixel (FindOutlines).
//   `background` and `hand` are CV_8UC3 of one size, `light` is theirs. Too few seeds on the object:
// ExtractHandMask's answer. An error when no object is seen, or one that has no outline.
Result<HandMask> RefineObjectMask(const cv::Mat& background, const cv::Mat& hand, const ObjectLight& light,
                                  const std::vector<ObjectSeed>& seeds, const ObjectMaskOptions& options,
                                  const Context& context = {});

}  // namespace dorsum
