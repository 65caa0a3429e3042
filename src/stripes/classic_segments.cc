// SPDX-License-Identifier: Apache-2.0
#include "stripes/classic_segments.h"

#include <algorithm>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// A boundary on whole pixels is off by up to half a pixel either way.
constexpr float kBoundarySd = 0.29F;

// Labels of the regions by the first pixel that a search column by column meets.
std::vector<int> InColumnOrder(const cv::Mat& labels, int count) {
  std::vector<int> order;
  std::vector<char> seen(static_cast<std::size_t>(count), 0);
  seen[0] = 1;
  for (int c = 0; c < labels.cols; ++c) {
    for (int r = 0; r < labels.rows; ++r) {
      const int label = labels.at<int>(r, c);
      if (seen[static_cast<std::size_t>(label)]) continue;
      seen[static_cast<std::size_t>(label)] = 1;
      order.push_back(label);
    }
  }
  return order;
}

// Brightest value near the boundary: the stripe's crest lies within a few pixels of it.
float PeakNear(const cv::Mat& green, int row, int column) {
  const auto* values = green.ptr<std::uint8_t>(row);
  std::uint8_t peak = 0;
  for (int c = std::max(0, column - 3); c <= std::min(green.cols - 1, column + 3); ++c) {
    peak = std::max(peak, values[c]);
  }
  return peak;
}

}  // namespace

LaserStripes ExtractClassicSegments(const cv::Mat& mask, const cv::Mat& green, int laser,
                                    const ClassicSegmentOptions& options) {
  LaserStripes out;
  out.laser = laser;
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8, CV_32S);
  for (const int label : InColumnOrder(labels, count)) {
    if (stats.at<int>(label, cv::CC_STAT_AREA) < options.min_area_px) continue;
    const int top = stats.at<int>(label, cv::CC_STAT_TOP), rows = stats.at<int>(label, cv::CC_STAT_HEIGHT);
    const int left = stats.at<int>(label, cv::CC_STAT_LEFT), width = stats.at<int>(label, cv::CC_STAT_WIDTH);
    if (rows < options.min_rows) continue;
    StripeSegment segment;
    segment.first = static_cast<std::int32_t>(out.points.size());
    double sum = 0.0;
    for (int r = top; r < top + rows; ++r) {
      const auto* row = labels.ptr<int>(r);
      const auto* edge = std::find(row + left, row + left + width, label);
      if (edge == row + left + width) continue;
      const int column = static_cast<int>(edge - row);
      StripePoint p;
      p.u = static_cast<float>(column);
      p.v = static_cast<float>(r);
      p.sd_px = kBoundarySd;
      p.peak = PeakNear(green, r, column);
      p.segment = static_cast<std::int32_t>(out.segments.size());
      sum += p.peak;
      out.points.push_back(p);
    }
    segment.count = static_cast<std::int32_t>(out.points.size()) - segment.first;
    segment.mean_peak = static_cast<float>(sum / segment.count);
    out.segments.push_back(segment);
  }
  return out;
}

}  // namespace dorsum
