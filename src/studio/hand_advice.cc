// SPDX-License-Identifier: Apache-2.0
#include "studio/hand_advice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <opencv2/imgproc.hpp>

#include "imaging/hand_mask.h"
#include "imaging/motion.h"
#include "imaging/unchanged_part.h"
#include "studio/hand_fingers.h"

namespace dorsum {
namespace {

constexpr int kWidth = 400;           // px that a picture is reduced to
constexpr double kMargin = 0.02;      // of the width: a finger that comes so near to the border leaves soon
constexpr double kRest_px = 0.4;      // of reduced pictures, whose noise looks like 0.25 at most
constexpr double kUnchanged = 0.2;    // share of the light by which an empty backplane may differ
constexpr double kSkin = 0.72;        // of the light missing in the hand's middle, that is missing at its rim
constexpr double kHalf = 0.5;         // of the picture
constexpr double kPalmInside = 1.15;  // palm radii from the palm's centre to the border, at least

// A way along the picture's border on which the hand crosses it.
struct Crossing {
  int length = 0;
  cv::Point2d middle;  // px
};

// The crossings of the border, the longest first. The border is one closed line, so that an arm in a corner
// is one crossing.
std::vector<Crossing> FindCrossings(const cv::Mat& mask) {
  std::vector<cv::Point> line;
  const int w = mask.cols, h = mask.rows;
  line.reserve(static_cast<std::size_t>(2) * (static_cast<std::size_t>(w) + static_cast<std::size_t>(h)));
  for (int u = 0; u < w; ++u) line.emplace_back(u, 0);
  for (int v = 1; v < h; ++v) line.emplace_back(w - 1, v);
  for (int u = w - 2; u >= 0; --u) line.emplace_back(u, h - 1);
  for (int v = h - 2; v > 0; --v) line.emplace_back(0, v);
  const auto on = [&](std::size_t i) { return mask.at<uchar>(line[i % line.size()]) != 0; };
  std::size_t start = 0;
  while (start < line.size() && on(start)) ++start;
  std::vector<Crossing> found;
  if (start == line.size()) return found;
  for (std::size_t i = start; i < start + line.size(); ++i) {
    if (!on(i)) continue;
    if (!on(i - 1 + line.size())) found.emplace_back();
    ++found.back().length;
    found.back().middle += cv::Point2d(line[i % line.size()]);
  }
  for (Crossing& crossing : found) crossing.middle *= 1.0 / crossing.length;
  std::sort(found.begin(), found.end(),
            [](const Crossing& a, const Crossing& b) { return a.length > b.length; });
  return found;
}

// The part of a rough mask in which nearly as much light is missing as in its middle: without the soft shadow
// around it. Shadow between fingers is as dark as skin, and stays.
cv::Mat WithoutShadow(const cv::Mat& rough, const cv::Mat& background, const cv::Mat& picture) {
  cv::Mat before, after, missing, middle, mask;
  cv::extractChannel(background, before, 1);
  cv::extractChannel(picture, after, 1);
  cv::divide(after, cv::max(before, 1), missing, 255.0);
  missing = 255 - missing;
  cv::erode(rough, middle, cv::Mat::ones(15, 15, CV_8UC1), {-1, -1}, 1, cv::BORDER_REPLICATE);
  if (cv::countNonZero(middle) == 0) return rough;
  mask = rough & (missing > kSkin * cv::mean(missing, middle)[0]);
  cv::erode(middle, middle, cv::Mat::ones(15, 15, CV_8UC1), {-1, -1}, 1, cv::BORDER_REPLICATE);
  mask |= middle;
  cv::morphologyEx(mask, mask, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8UC1));
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8, CV_32S);
  int best = 0;
  for (int i = 1; i < count; ++i) {
    if (best == 0 || stats.at<int>(i, cv::CC_STAT_AREA) > stats.at<int>(best, cv::CC_STAT_AREA)) best = i;
  }
  return best == 0 ? rough : cv::Mat(labels == best);
}

// Away from a place on the border.
Advice AwayFrom(const cv::Point2d& place, cv::Size size) {
  const double left = place.x, right = size.width - 1.0 - place.x;
  const double top = place.y, bottom = size.height - 1.0 - place.y;
  const double nearest = std::min({left, right, top, bottom});
  if (nearest == right) return Advice::kMoveLeft;
  if (nearest == left) return Advice::kMoveRight;
  return nearest == top ? Advice::kMoveDown : Advice::kMoveUp;
}

}  // namespace

cv::Mat ReducePicture(const cv::Mat& picture, int width) {
  if (picture.cols <= width) return picture;
  cv::Mat small;
  const double scale = static_cast<double>(width) / picture.cols;
  cv::resize(picture, small, {width, std::max(1, static_cast<int>(std::lround(scale * picture.rows)))}, 0, 0,
             cv::INTER_AREA);
  return small;
}

HandAdvisor::HandAdvisor(const cv::Mat& background)
    : size_(background.size()), background_(ReducePicture(background, kWidth)) {}

HandView HandAdvisor::Look(const cv::Mat& picture, double time_s) {
  if (picture.size() != size_ || picture.type() != CV_8UC3) {
    throw std::logic_error("HandAdvisor: picture and background differ in size or type");
  }
  HandView view;
  view.picture = ReducePicture(picture, kWidth);
  MotionOptions motion;
  motion.tile_px = 32;
  motion.blur_px = 1.5;
  if (!reference_ || MeasureMotion(*reference_, view.picture, motion).shift_px > kRest_px) {
    reference_ = view.picture;
    reference_s_ = time_s;
  }
  view.rested_s = time_s - reference_s_;

  HandMaskOptions options;
  options.open_px = 3;
  const Result<HandMask> hand = ExtractHandMask(background_, view.picture, options);
  if (!hand.ok()) {
    const cv::Mat unchanged = UnchangedPart(background_, view.picture).Mask(kUnchanged);
    const bool empty = cv::countNonZero(unchanged) > kHalf * static_cast<double>(unchanged.total());
    view.advice = empty ? Advice::kPutHandDown : Advice::kLightChanged;
    return view;
  }
  const cv::Mat mask = WithoutShadow(hand->mask, background_, view.picture);
  view.area_share = static_cast<double>(cv::countNonZero(mask)) / static_cast<double>(mask.total());
  cv::findContours(mask.clone(), view.outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  // Judged with its shadow: without it a forearm may be as thick as a palm.
  view.advice = Judge(hand->mask, &view);
  // A hand that comes has no rest to speak of: what changes the picture moves it.
  if (view.advice == Advice::kGood && view.rested_s <= 0.0) view.advice = Advice::kHoldStill;
  return view;
}

// The longest crossing of the border is the arm; whatever else crosses it is cut off.
Advice HandAdvisor::Judge(const cv::Mat& mask, HandView* view) {
  const int margin = static_cast<int>(kMargin * mask.cols);
  const cv::Mat inner = mask(cv::Rect(margin, margin, mask.cols - 2 * margin, mask.rows - 2 * margin));
  const std::vector<Crossing> crossings = FindCrossings(inner);
  const HandParts parts = FindFingers(mask);
  view->fingers = static_cast<int>(parts.fingers.size());
  if (crossings.size() > 1) return AwayFrom(crossings[1].middle, inner.size());
  const cv::Point palm = parts.palm.centre;
  const double to_border = std::min({palm.x, palm.y, mask.cols - 1 - palm.x, mask.rows - 1 - palm.y});
  if (!crossings.empty() && to_border < kPalmInside * parts.palm.radius_px) {
    return AwayFrom(palm, mask.size());
  }
  return view->fingers == 5 ? Advice::kGood : Advice::kSpreadFingers;
}

}  // namespace dorsum
