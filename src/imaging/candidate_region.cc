// SPDX-License-Identifier: Apache-2.0
#include "imaging/candidate_region.h"

#include <vector>

#include <opencv2/imgproc.hpp>

#include "imaging/led_ratio.h"

namespace dorsum {
namespace {

constexpr int kScale = 4;   // px of the image in one of the small picture that this works on
constexpr int kSpeck = 25;  // small px: changes of less area are noise or dust
constexpr int kSmooth = 3;  // small px

// What has changed, without specks.
std::vector<cv::Point> ChangedPlaces(const cv::Mat& change, double least) {
  cv::Mat labels, stats, centroids;
  const cv::Mat changed = change > least;
  cv::connectedComponentsWithStats(changed, labels, stats, centroids, 8, CV_32S);
  std::vector<cv::Point> places;
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      const int label = labels.at<int>(v, u);
      if (label > 0 && stats.at<int>(label, cv::CC_STAT_AREA) >= kSpeck) places.emplace_back(u, v);
    }
  }
  return places;
}

}  // namespace

cv::Mat CandidateRegion(const cv::Mat& background, const cv::Mat& hand,
                        const CandidateRegionOptions& options) {
  cv::Mat everywhere(hand.size(), CV_8UC1, cv::Scalar(255));
  const cv::Mat light = LedRatio(background, hand, 2);
  cv::Mat change;
  const cv::Size small((hand.cols + kScale - 1) / kScale, (hand.rows + kScale - 1) / kScale);
  cv::resize(light, change, small, 0, 0, cv::INTER_AREA);
  cv::blur(change, change, {kSmooth, kSmooth});
  change = cv::abs(change - 1.0);

  const std::vector<cv::Point> places = ChangedPlaces(change, options.changed);
  if (places.empty()) return everywhere;
  std::vector<cv::Point> hull;
  cv::convexHull(places, hull);
  cv::Mat region = cv::Mat::zeros(small, CV_8UC1);
  cv::fillConvexPoly(region, hull, 255);
  if (cv::countNonZero((change > options.strong) & region) < options.strong_share * cv::countNonZero(region))
    return everywhere;

  cv::Mat far;
  cv::distanceTransform(region == 0, far, cv::DIST_L2, cv::DIST_MASK_5);
  region = far <= static_cast<double>(options.margin_px) / kScale;
  cv::Mat out;
  cv::resize(region, out, hand.size(), 0, 0, cv::INTER_NEAREST);
  return out;
}

}  // namespace dorsum
