// SPDX-License-Identifier: Apache-2.0
#include "calibration/line_finder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

double BrightnessAlong(const cv::Mat& intensity, const VerticalLine& line) {
  if (intensity.empty()) return 0.0;
  double sum = 0.0;
  int count = 0;
  for (int r = 0; r < intensity.rows; ++r) {
    const int c = static_cast<int>(std::lround(line.at + line.slope * (r - 0.5 * (intensity.rows - 1))));
    if (c < 4 || c >= intensity.cols - 4) continue;
    const auto* row = intensity.ptr<std::uint8_t>(r);
    sum += *std::max_element(row + c - 4, row + c + 5);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

std::vector<VerticalLine> FindVerticalLines(const cv::Mat& mask, const cv::Mat& intensity,
                                            const LineFinderOptions& options) {
  const double middle = 0.5 * (mask.rows - 1);
  const double shortest = options.min_length_share * mask.rows;
  // Neighbouring rows say the same of a nearly vertical line, and each costs as much.
  const int every = std::clamp(mask.rows / 100, 1, 4);
  cv::Mat some = cv::Mat::zeros(mask.size(), CV_8UC1);
  for (int r = 0; r < mask.rows; r += every) mask.row(r).copyTo(some.row(r));
  std::vector<cv::Vec4i> pieces;
  cv::HoughLinesP(some, pieces, 1.0, std::numbers::pi / 720.0, static_cast<int>(0.5 * shortest / every),
                  shortest, options.max_gap_px);
  std::vector<VerticalLine> found;
  for (const cv::Vec4i& p : pieces) {
    const double rows = p[3] - p[1], columns = p[2] - p[0];
    if (std::abs(columns) > std::abs(rows) * std::tan(options.max_tilt_deg * std::numbers::pi / 180.0))
      continue;
    VerticalLine line;
    line.slope = columns / rows;
    line.at = 0.5 * (p[0] + p[2]) + line.slope * (middle - 0.5 * (p[1] + p[3]));
    line.weight = std::hypot(rows, columns);
    found.push_back(line);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  std::vector<VerticalLine> merged;
  double previous = -1e9;
  for (const VerticalLine& line : found) {
    if (line.at - previous > options.merge_px) {
      merged.push_back({});
    }
    previous = line.at;
    VerticalLine& sum = merged.back();
    sum.at += line.weight * line.at;
    sum.slope += line.weight * line.slope;
    sum.weight += line.weight;
  }
  for (VerticalLine& line : merged) {
    line.at /= line.weight;
    line.slope /= line.weight;
    line.brightness = BrightnessAlong(intensity, line);
  }
  return merged;
}

}  // namespace dorsum
