// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// What the person should do next. Directions are those of the picture.
enum class Advice {
  kPutHandDown,   // nothing lies there
  kLightChanged,  // the picture differs from the background nearly everywhere
  kMoveLeft,
  kMoveRight,
  kMoveUp,
  kMoveDown,
  kSpreadFingers,  // fewer than five fingers stand alone
  kHoldStill,      // all is well but it moves
  kGood,
};

struct HandView {
  Advice advice = Advice::kPutHandDown;
  cv::Mat picture;                               // what was looked at, reduced, CV_8UC3
  std::vector<std::vector<cv::Point>> outlines;  // of the hand, px of `picture`
  double area_share = 0.0;                       // of the picture that the hand covers
  int fingers = 0;                               // that stand alone
  double rested_s = 0.0;                         // for how long nothing has moved
};

// Looks at live pictures under the LEDs, one after the other. Works on pictures of a few hundred pixels'
// width, since its answer is wanted at once.
class HandAdvisor {
 public:
  // The empty backplane under the LEDs, CV_8UC3.
  explicit HandAdvisor(const cv::Mat& background);

  // `picture`: CV_8UC3, of the background's size (else std::logic_error); time_s: when it was exposed.
  HandView Look(const cv::Mat& picture, double time_s);

  cv::Size size() const { return size_; }

 private:
  static Advice Judge(const cv::Mat& mask, HandView* view);

  cv::Size size_;
  cv::Mat background_;                // reduced
  std::optional<cv::Mat> reference_;  // the picture since which nothing has moved, reduced
  double reference_s_ = 0.0;
};

// The picture reduced to at most `width` pixels' width.
cv::Mat ReducePicture(const cv::Mat& picture, int width);

}  // namespace dorsum
