// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "stripes/ridge_survey.h"

namespace dorsum {
namespace {

ProfileStart StartOf(const std::vector<RidgeCandidate>& row, std::size_t i, double width, int cols) {
  ProfileStart start;
  start.u = static_cast<double>(row[i].u);
  start.width = width;
  start.last = cols - 1;
  if (i > 0) start.first = static_cast<int>(std::ceil(0.5 * static_cast<double>(row[i - 1].u + row[i].u)));
  if (i + 1 < row.size()) {
    start.last = static_cast<int>(std::floor(0.5 * static_cast<double>(row[i].u + row[i + 1].u)));
  }
  return start;
}

std::vector<StripePoint> MeasureRow(const std::uint8_t* pixels, const std::vector<RidgeCandidate>& row, int v,
                                    int cols, const RidgeSurvey& survey, const RidgeOptions& options) {
  std::vector<StripePoint> points;
  points.reserve(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    const ProfileFit fit =
        FitProfile(pixels, StartOf(row, i, survey.width_px, cols), survey.noise, options.fit);
    if (!fit.ok || fit.width > options.max_width_ratio * survey.width_px) continue;
    // Where the image cuts the profile near its middle, width and centre cannot be told apart.
    if (fit.u < 0.7 * fit.width || fit.u > cols - 1.0 - 0.7 * fit.width) continue;
    StripePoint p;
    p.u = static_cast<float>(fit.u);
    p.v = static_cast<float>(v);
    p.sd_px = static_cast<float>(fit.sd_u);
    p.peak = static_cast<float>(std::min(255.0, fit.amplitude));
    p.width = static_cast<float>(fit.width);
    points.push_back(p);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const StripePoint& p, const StripePoint& q) { return p.u < q.u; });
  return points;
}

// Rows at the beginning of `points` whose amplitude is less than a share of what follows.
std::size_t WeakRows(const std::vector<StripePoint>& points, const RidgeOptions& options) {
  const auto window = static_cast<std::size_t>(options.end_rows);
  std::vector<float> peaks;
  std::size_t weak = 0;
  for (; weak + window / 2 < points.size(); ++weak) {
    peaks.clear();
    for (std::size_t i = weak + 1; i < std::min(points.size(), weak + 1 + window); ++i) {
      peaks.push_back(points[i].peak);
    }
    const auto middle = peaks.begin() + static_cast<std::ptrdiff_t>(peaks.size() / 2);
    std::nth_element(peaks.begin(), middle, peaks.end());
    if (static_cast<double>(points[weak].peak) >= options.end_share * static_cast<double>(*middle)) break;
  }
  return weak;
}

// Compression leaves faint traces as long as its blocks: short segments must be bright, dim ones long.
bool IsEvident(const std::vector<StripePoint>& points, const NoiseModel& noise, const RidgeOptions& options) {
  if (static_cast<int>(points.size()) < options.linking.min_rows) return false;
  double sum = 0.0;
  for (const StripePoint& p : points) sum += static_cast<double>(p.peak);
  return sum >= options.min_evidence * std::sqrt(noise.Variance(0.0));
}

LaserStripes TrimEnds(const LaserStripes& stripes, const NoiseModel& noise, const RidgeOptions& options) {
  std::vector<std::vector<StripePoint>> kept;
  for (const StripeSegment& s : stripes.segments) {
    const auto first = stripes.points.begin() + s.first;
    std::vector<StripePoint> points(first, first + s.count);
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(WeakRows(points, options)));
    std::reverse(points.begin(), points.end());
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(WeakRows(points, options)));
    std::reverse(points.begin(), points.end());
    if (IsEvident(points, noise, options)) kept.push_back(std::move(points));
  }
  return AssembleStripes(kept, stripes.laser);
}

}  // namespace

LaserStripes FindRidges(const cv::Mat& green, const cv::Mat& region, int laser, const RidgeOptions& options,
                        const Context& context) {
  const RidgeSurvey survey =
      SurveyRidges(green, region, options.width_px, options.detection, options.fit, context);
  LaserStripes none;
  none.laser = laser;
  if (!(survey.width_px > 0.0)) return none;
  RidgeDetectionOptions detection = options.detection;
  detection.width_px = survey.width_px;
  const auto candidates = DetectRidges(green, region, survey.noise, detection, context);
  std::vector<std::vector<StripePoint>> rows(candidates.size());
  ParallelFor(context, 0, green.rows, [&](std::int64_t row) {
    const auto i = static_cast<std::size_t>(row);
    rows[i] = MeasureRow(green.ptr<std::uint8_t>(static_cast<int>(row)), candidates[i], static_cast<int>(row),
                         green.cols, survey, options);
  });
  if (getenv("DBG"))
    fprintf(stderr, "width %.2f noise %.2f %.3f %.4f\n", survey.width_px, survey.noise.constant,
            survey.noise.linear, survey.noise.quadratic);
  const LaserStripes linked = LinkSegments(rows, laser, options.linking);
  const LaserStripes mended =
      MendCutStripes(green, linked, survey.noise, survey.width_px, options.fit, options.cut, context);
  return TrimEnds(mended, survey.noise, options);
}

}  // namespace dorsum
