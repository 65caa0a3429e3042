// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "accuracy/capture_truth.h"
#include "speed/figures.h"

namespace dorsum::speed {

// How far a detector's points lie from the true stripes of the same picture: by true stripe point the column
// of the nearest found point less the stripe's, px; NaN where none is within 1.5 px in that row. A point off
// the middle of its row is compared with the column that the stripe has where the point lies. `truth` by row.
std::vector<double> ErrorsAgainst(const std::vector<accuracy::TrueStripe>& truth,
                                  const std::vector<cv::Point2f>& points);

// Two detectors in pictures with truth.
class DetectorComparison {
 public:
  // One picture's points.
  void Add(const std::vector<accuracy::TrueStripe>& truth, const std::vector<cv::Point2f>& ours,
           const std::vector<cv::Point2f>& theirs);

  // By "object/" and "backplane/": "ours/found", the share of the true, lit stripe points that were found,
  // and "ours/rms_px" and "ours/median_px" of the errors where both found them; and the same for "theirs/".
  Measured Summary() const;

 private:
  struct Errors {
    std::vector<double> ours, theirs;
  };
  Errors object_, backplane_;
};

}  // namespace dorsum::speed
