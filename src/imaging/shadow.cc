// SPDX-License-Identifier: Apache-2.0
#include "imaging/shadow.h"

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// Distance of every pixel to the nearest of the places; the mask's first pixel is `corner`.
cv::Mat DistanceTo(const std::vector<cv::Point>& places, cv::Point corner, const cv::Mat& mask) {
  cv::Mat free(mask.size(), CV_8UC1, cv::Scalar(255));
  const cv::Rect image({0, 0}, mask.size());
  for (const cv::Point& place : places) {
    const cv::Point p = place - corner;
    if (image.contains(p) && mask.at<std::uint8_t>(p) != 0) free.at<std::uint8_t>(p) = 0;
  }
  cv::Mat distance;
  cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_5);
  return distance;
}

void DropSmallRegions(double min_area_px, cv::Mat* mask) {
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(*mask, labels, stats, centroids, 8, CV_32S);
  for (int i = 1; i < count; ++i) {
    if (stats.at<int>(i, cv::CC_STAT_AREA) < min_area_px) mask->setTo(0, labels == i);
  }
}

}  // namespace

cv::Mat RemoveShadow(const cv::Mat& mask, const std::vector<cv::Point>& object,
                     const std::vector<cv::Point>& backplane, double min_area_share) {
  cv::Mat out = mask.clone();
  const cv::Rect within = cv::boundingRect(mask);
  if (backplane.empty() || object.empty() || within.empty()) return out;
  // What is compared, and the shortest ways between it, lies in this part of the image.
  const cv::Mat part = mask(within);
  const cv::Mat shadow = DistanceTo(backplane, within.tl(), part) < DistanceTo(object, within.tl(), part);
  out(within).setTo(0, shadow);
  DropSmallRegions(min_area_share * static_cast<double>(mask.total()), &out);
  return out;
}

}  // namespace dorsum
