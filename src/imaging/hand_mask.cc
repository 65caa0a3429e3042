// SPDX-License-Identifier: Apache-2.0
#include "imaging/hand_mask.h"

#include <opencv2/imgproc.hpp>

#include "imaging/iterative_threshold.h"
#include "imaging/stage_sink.h"

namespace dorsum {
namespace {

// Keeps the region with the most pixels: specks far from the hand are not the hand.
cv::Mat LargestRegion(const cv::Mat& mask) {
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8, CV_32S);
  int best = 0;
  for (int i = 1; i < count; ++i) {
    if (best == 0 || stats.at<int>(i, cv::CC_STAT_AREA) > stats.at<int>(best, cv::CC_STAT_AREA)) best = i;
  }
  if (best == 0) return cv::Mat::zeros(mask.size(), CV_8UC1);
  return labels == best;
}

// |background - hand| / background in the G channel, 255 for a full change. Dividing by the background makes
// one threshold fit the image's bright middle and its dark corners, and puts a shadow, which takes a part of
// the light away, well below skin.
cv::Mat RelativeDifference(const cv::Mat& background, const cv::Mat& hand) {
  constexpr float kDarkest = 8.0F;  // grey values; below it the ratio is noise
  cv::Mat before, after, difference, relative;
  cv::extractChannel(background, before, 1);
  cv::extractChannel(hand, after, 1);
  cv::absdiff(before, after, difference);
  before.convertTo(before, CV_32F);
  difference.convertTo(difference, CV_32F);
  const cv::Mat floor = cv::max(before, kDarkest);
  cv::divide(difference, floor, relative, 255.0);
  relative.convertTo(relative, CV_8U);
  return relative;
}

}  // namespace

Result<HandMask> ExtractHandMask(const cv::Mat& background, const cv::Mat& hand,
                                 const HandMaskOptions& options, const Context& context) {
  const cv::Mat green = RelativeDifference(background, hand);
  Sink(context, "mask/difference", green);

  HandMask result;
  result.threshold = IterativeThreshold(green);
  cv::Mat raw;
  cv::threshold(green, raw, result.threshold, 255, cv::THRESH_BINARY);
  Sink(context, "mask/threshold", raw);
  const cv::Mat object_pixels = raw != 0, other_pixels = raw == 0;
  const double change_elsewhere = cv::mean(green, other_pixels)[0];
  const double contrast = cv::mean(green, object_pixels)[0] - change_elsewhere;

  cv::Mat opened;
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {options.open_px, options.open_px});
  cv::morphologyEx(raw, opened, cv::MORPH_OPEN, square);
  result.mask = LargestRegion(opened);
  result.area_share =
      static_cast<double>(cv::countNonZero(result.mask)) / static_cast<double>(result.mask.total());
  Sink(context, "mask/mask", result.mask);
  const bool nothing = contrast < options.min_contrast || result.area_share < options.min_area_share;
  if (nothing && change_elsewhere < options.min_contrast) {
    return BadInput(
        "no hand is seen in bgHand: it looks like the empty background; put the hand down and capture again");
  }
  if (nothing || result.area_share > options.max_area_share) {
    return BadInput(
        "bgHand differs from the background nearly everywhere; the light or the camera changed since the "
        "calibration, so calibrate again");
  }
  return result;
}

}  // namespace dorsum
