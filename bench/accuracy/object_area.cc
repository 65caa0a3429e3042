// SPDX-License-Identifier: Apache-2.0
#include "accuracy/object_area.h"

#include <opencv2/imgproc.hpp>

namespace dorsum::accuracy {

cv::Mat1b ObjectArea(const CaptureTruth& truth, int margin_px) {
  cv::Mat1b area(truth.material.size());
  for (int v = 0; v < area.rows; ++v) {
    for (int u = 0; u < area.cols; ++u) area(v, u) = CaptureTruth::IsObject(truth.material(v, u)) ? 1 : 0;
  }
  const int side = 2 * margin_px + 1;
  if (margin_px > 0) cv::dilate(area, area, cv::Mat1b::ones(side, side));
  return area;
}

}  // namespace dorsum::accuracy
