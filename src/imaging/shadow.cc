// SPDX-License-Identifier: Apache-2.0
#include "imaging/shadow.h"

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// Distance of every pixel to the nearest of the places.
cv::Mat DistanceTo(const std::vector<cv::Point>& places, const cv::Mat& mask) {
  cv::Mat free(mask.size(), CV_8UC1, cv::Scalar(255));
  const cv::Rect image({0, 0}, mask.size());
  for (const cv::Point& p : places) {
    if (image.contains(p) && mask.at<std::uint8_t>(p) != 0) free.at<std::uint8_t>(p) = 0;
  }
  cv::Mat distance;
  cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_5);
  return distance;
}

}  // namespace

cv::Mat RemoveShadow(const cv::Mat& mask, const std::vector<cv::Point>& object,
                     const std::vector<cv::Point>& backplane) {
  if (backplane.empty() || object.empty()) return mask.clone();
  const cv::Mat shadow = DistanceTo(backplane, mask) < DistanceTo(object, mask);
  cv::Mat out = mask.clone();
  out.setTo(0, shadow);
  return out;
}

}  // namespace dorsum
