// SPDX-License-Identifier: Apache-2.0
#include "studio/finger_quality.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "studio/hand_fingers.h"

namespace dorsum {
namespace {

constexpr int kWidth = 400;  // px of the mask in which fingers are told apart

// Where the surface's heights are seen, in a picture of `scale` times the size.
cv::Mat SeenSurface(const HeightField& field, const Camera& camera, cv::Size size, double scale) {
  cv::Mat seen(size, CV_8UC1, cv::Scalar(0));
  for (int r = 0; r < field.z.rows; ++r) {
    for (int c = 0; c < field.z.cols; ++c) {
      const float z = field.z(r, c);
      if (std::isnan(z)) continue;
      const Eigen::Vector3d world(field.origin_mm.x() + field.pitch_mm * c,
                                  field.origin_mm.y() + field.pitch_mm * r, static_cast<double>(z));
      const Eigen::Vector2d pixel = Project(camera, world) * scale;
      const cv::Point p(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
      if (cv::Rect({}, size).contains(p)) seen.at<uchar>(p) = 255;
    }
  }
  // Heights may lie further apart than pixels.
  cv::morphologyEx(seen, seen, cv::MORPH_CLOSE, cv::Mat::ones(3, 3, CV_8UC1));
  return seen;
}

}  // namespace

std::vector<FingerQuality> JudgeFingers(const Reconstruction& surface, const Camera& camera) {
  const cv::Mat& mask = surface.mask.mask;
  if (mask.empty()) return {};
  const double scale = std::min(1.0, static_cast<double>(kWidth) / mask.cols);
  cv::Mat small;
  cv::resize(mask, small, {}, scale, scale, cv::INTER_NEAREST);
  const HandParts parts = FindFingers(small);
  if (parts.fingers.size() != 5) return {};
  const cv::Mat seen = SeenSurface(surface.height_field, camera, small.size(), scale);
  std::vector<FingerQuality> fingers;
  for (const cv::Mat& part : parts.fingers) {
    FingerQuality finger;
    finger.covered = static_cast<double>(cv::countNonZero(part & seen)) / cv::countNonZero(part);
    std::vector<float> sigma;
    for (const SurfacePoint& point : surface.points) {
      const cv::Point p(static_cast<int>(point.u * scale), static_cast<int>(point.v * scale));
      if (cv::Rect({}, part.size()).contains(p) && part.at<uchar>(p) != 0) sigma.push_back(point.sigma);
    }
    finger.points = static_cast<int>(sigma.size());
    if (!sigma.empty()) {
      const auto middle = sigma.begin() + static_cast<std::ptrdiff_t>(sigma.size() / 2);
      std::nth_element(sigma.begin(), middle, sigma.end());
      finger.sigma_mm = static_cast<double>(*middle);
    }
    fingers.push_back(finger);
  }
  return fingers;
}

}  // namespace dorsum
