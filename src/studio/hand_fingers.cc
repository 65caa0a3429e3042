// SPDX-License-Identifier: Apache-2.0
#include "studio/hand_fingers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

constexpr double kOpening = 0.42;  // of the palm's radius: between half a finger's width and half a wrist's
constexpr double kReach = 1.25;    // palm radii from the palm's centre that a finger's tip lies away at least
constexpr double kLeastArea = 0.03;  // of the palm's circle
constexpr double kWidest = 0.33;     // half the width of one finger, palm radii; two together are wider

// Taken on a mask with a rim of hand where the hand leaves the picture, so that the border parts nothing.
cv::Mat Thick(const cv::Mat& mask, double radius) {
  cv::Mat far, core, to_core;
  cv::Mat wide;
  const int rim = static_cast<int>(radius) + 2;
  cv::copyMakeBorder(mask, wide, rim, rim, rim, rim, cv::BORDER_REPLICATE);
  cv::distanceTransform(wide, far, cv::DIST_L2, 5);
  core = far <= radius;  // 0 where the whole circle fits
  if (cv::countNonZero(core) == static_cast<int>(core.total())) return cv::Mat::zeros(mask.size(), CV_8UC1);
  cv::distanceTransform(core, to_core, cv::DIST_L2, 5);
  const cv::Mat thick = to_core <= radius + 1.0;
  return thick(cv::Rect({rim, rim}, mask.size())).clone();
}

// Direction in which the arm lies: the mean of the hand's pixels on the picture's border, else of the hand.
cv::Point2d ArmFrom(const cv::Mat& mask, const cv::Point& palm) {
  std::vector<cv::Point> border;
  for (int u = 0; u < mask.cols; ++u) {
    if (mask.at<uchar>(0, u) != 0) border.emplace_back(u, 0);
    if (mask.at<uchar>(mask.rows - 1, u) != 0) border.emplace_back(u, mask.rows - 1);
  }
  for (int v = 0; v < mask.rows; ++v) {
    if (mask.at<uchar>(v, 0) != 0) border.emplace_back(0, v);
    if (mask.at<uchar>(v, mask.cols - 1) != 0) border.emplace_back(mask.cols - 1, v);
  }
  cv::Point2d mean(-1.0, 0.0);
  if (border.empty()) return mean;
  mean = {};
  for (const cv::Point& p : border) mean += cv::Point2d(p - palm);
  return mean;
}

}  // namespace

HandParts FindFingers(const cv::Mat& mask) {
  HandParts parts;
  const cv::Mat hand = mask != 0;
  cv::Mat far;
  cv::copyMakeBorder(hand, far, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(far, far, cv::DIST_L2, 5);
  cv::minMaxLoc(far, nullptr, &parts.palm.radius_px, nullptr, &parts.palm.centre);
  parts.palm.centre -= cv::Point(1, 1);
  const double radius = parts.palm.radius_px;
  if (radius < 4.0) return {};

  cv::Mat thin = hand & ~Thick(hand, kOpening * radius);
  // Along the palm thin rims remain, which would join the fingers.
  cv::morphologyEx(thin, thin, cv::MORPH_OPEN, cv::Mat::ones(5, 5, CV_8UC1));
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(thin, labels, stats, centroids, 4, CV_32S);
  const cv::Point2d arm = ArmFrom(hand, parts.palm.centre);
  const double arm_angle = std::atan2(arm.y, arm.x);
  std::vector<std::pair<double, cv::Mat>> found;
  for (int i = 1; i < count; ++i) {
    if (stats.at<int>(i, cv::CC_STAT_AREA) < kLeastArea * std::numbers::pi * radius * radius) continue;
    const cv::Point2d middle(centroids.at<double>(i, 0), centroids.at<double>(i, 1));
    const cv::Point2d way = middle - cv::Point2d(parts.palm.centre);
    // Clockwise on the screen, where v points down, is the way in which the angle grows.
    double turn = std::atan2(way.y, way.x) - arm_angle;
    while (turn < 0.0) turn += 2.0 * std::numbers::pi;
    if (turn < 0.2 * std::numbers::pi || turn > 1.8 * std::numbers::pi) continue;
    const cv::Mat part = labels == i;
    std::vector<cv::Point> pixels;
    cv::findNonZero(part, pixels);
    double reach = 0.0;
    for (const cv::Point& p : pixels) reach = std::max(reach, cv::norm(p - parts.palm.centre));
    if (reach < kReach * radius) continue;
    const cv::RotatedRect box = cv::minAreaRect(pixels);
    if (std::min(box.size.width, box.size.height) > 2.0 * kWidest * radius) continue;
    found.emplace_back(turn, part);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [turn, part] : found) parts.fingers.push_back(std::move(part));
  return parts;
}

}  // namespace dorsum
