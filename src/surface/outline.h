// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

// Signed distance to an object's outline in the image, px: positive inside, zero half way between the last
// pixel inside and the first one outside. The image's own border is no outline: an arm goes on beyond it.
class Outline {
 public:
  // `mask`: CV_8UC1, not 0 on the object. Distances are known within `margin_px` around the object and, where
  // no more is asked for, `reach_px` inside: what lies deeper is as far as that.
  Outline(const cv::Mat& mask, int margin_px, int reach_px = std::numeric_limits<int>::max(),
          const Context& context = {});

  // Bilinear between pixel centres; far outside -margin.
  float Distance(double u, double v) const;
  // The same at the nodes of a lattice (plate.h) of this size.
  cv::Mat1f AtNodes(double u0, double v0, double step_px, cv::Size size, const Context& context = {}) const;

  // The object's bounding box with the margin, cut at the image.
  const cv::Rect& bounds() const { return bounds_; }

 private:
  cv::Rect bounds_;
  cv::Mat1f distance_;
  float outside_;
};

}  // namespace dorsum
