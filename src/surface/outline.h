// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

// Signed distance to an object's outline in the image, px: positive inside, zero half way between the last
// pixel inside and the first one outside. The image's own border is no outline: an arm goes on beyond it.
class Outline {
 public:
  // `mask`: CV_8UC1, not 0 on the object. Distances are known within `margin_px` around the object.
  Outline(const cv::Mat& mask, int margin_px);

  // Bilinear between pixel centres; far outside -margin.
  float Distance(double u, double v) const;

  // The object's bounding box with the margin, cut at the image.
  const cv::Rect& bounds() const { return bounds_; }

 private:
  cv::Rect bounds_;
  cv::Mat1f distance_;
  float outside_;
};

}  // namespace dorsum
