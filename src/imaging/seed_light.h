// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "imaging/cell_picture.h"

namespace dorsum {

// What known pixels of a picture tell about the others nearby. `known` is CV_8UC1 (imaging/seed_map.h),
// `light` CV_32FC1.
class SeedLight {
 public:
  SeedLight(const cv::Mat& light, const cv::Mat& known, const Context& context = {});

  // How much neighbouring pixels differ where there is no outline: noise, mottle, the slope of shadows.
  const CellPicture& usual_texture() const { return texture_; }
  // -1 to 1: whether light at a place looks more like the object's (> 0) or the backplane's around there.
  float LikeObject(int u, int v, float light) const;

 private:
  struct Kind {
    CellPicture mean, square;
  };
  static float Density(const Kind& kind, int u, int v, float light);

  CellPicture texture_;
  Kind object_, backplane_;
};

}  // namespace dorsum
