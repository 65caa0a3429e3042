// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "stripes/row_noise.h"

namespace dorsum {
namespace {

// Rows whose profiles are fitted together, so that the fits of a few do not leave lanes empty.
constexpr int kRowsTogether = 16;

// Fits the candidates of the rows from `first` on; points of each row by growing column.
void MeasureRows(const cv::Mat& green, const std::vector<std::vector<RidgeCandidate>>& candidates, int first,
                 const RidgeSurvey& survey, const RidgeOptions& options,
                 std::vector<std::vector<StripePoint>>* rows) {
  const int end = std::min(green.rows, first + kRowsTogether);
  std::vector<ProfileTask> tasks;
  for (int v = first; v < end; ++v) {
    const std::vector<RidgeCandidate>& row = candidates[static_cast<std::size_t>(v)];
    for (std::size_t i = 0; i < row.size(); ++i) {
      tasks.push_back({green.ptr<std::uint8_t>(v), StartBetween(row, i, survey.width_px, green.cols)});
    }
  }
  const std::vector<ProfileFit> fits = FitProfiles(tasks, survey.noise, options.fit);
  auto next = fits.begin();
  for (int v = first; v < end; ++v) {
    std::vector<StripePoint>& points = (*rows)[static_cast<std::size_t>(v)];
    for (std::size_t i = 0; i < candidates[static_cast<std::size_t>(v)].size(); ++i) {
      const ProfileFit& fit = *next++;
      if (!fit.ok || fit.width > options.max_width_ratio * survey.width_px) continue;
      StripePoint p;
      p.u = static_cast<float>(fit.u);
      p.v = static_cast<float>(v);
      p.sd_px = static_cast<float>(fit.sd_u);
      p.peak = static_cast<float>(std::min(255.0, fit.amplitude));
      p.width = static_cast<float>(fit.width);
      points.push_back(p);
    }
    const auto before = [](const StripePoint& p, const StripePoint& q) { return p.u < q.u; };
    if (!std::is_sorted(points.begin(), points.end(), before))
      std::stable_sort(points.begin(), points.end(), before);
  }
}

// What the row before points[at] .. points[at + rows - 1] should show if the amplitude went on as it does
// there: the line through them, but not below half their mean.
double ExpectedPeak(const std::vector<StripePoint>& points, std::size_t at, std::size_t rows) {
  const auto n = static_cast<double>(rows);
  double mean = 0.0, slope = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) - 0.5 * (n - 1.0);
    const auto peak = static_cast<double>(points[at + i].peak);
    mean += peak / n;
    slope += t * peak;
    spread += t * t;
  }
  return std::max(0.5 * mean, mean - slope / spread * 0.5 * (n + 3.0));
}

// Rows at the beginning of `points` that show less than a share of what the rows after the next one foretell:
// the light there is blur from beyond the stripe's end.
std::size_t WeakRows(const std::vector<StripePoint>& points, const RidgeOptions& options) {
  const auto window = static_cast<std::size_t>(options.end_rows);
  std::size_t weak = 0;
  const auto is_weak = [&](std::size_t i) {
    const auto peak = static_cast<double>(points[i].peak);
    if (peak < options.end_share * ExpectedPeak(points, i + 2, window)) return true;
    double mean = 0.0;
    for (std::size_t k = 1; k <= window; ++k) mean += static_cast<double>(points[i + k].peak);
    return peak < options.far_end_share * mean / static_cast<double>(window);
  };
  while (weak + 2 + window <= points.size() && is_weak(weak)) ++weak;
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

// By the scatter along each stripe.
LaserStripes ScaleDeviations(LaserStripes stripes) {
  std::vector<StripeCurve> curves = CurvesOf(stripes);
  const RowNoise noise = MeasureRowNoise({}, &curves);
  for (std::size_t i = 0; i < stripes.segments.size(); ++i) {
    const StripeSegment& s = stripes.segments[i];
    for (std::int32_t k = s.first; k < s.first + s.count; ++k) {
      stripes.points[static_cast<std::size_t>(k)].sd_px *= static_cast<float>(noise.per_curve[i]);
    }
  }
  return stripes;
}

}  // namespace

LaserStripes FindRidges(const cv::Mat& green, const cv::Mat& region, int laser, const RidgeOptions& options,
                        const Context& context, NoiseModel* noise) {
  // Width and noise are the picture's own, so that of a large one fewer rows tell them.
  const RowComb rows{kSurveyedRows.first, kSurveyedRows.step * (green.rows < 800 ? 1 : 2)};
  const RidgeSurvey survey =
      SurveyRidges(green, region, options.width_px, options.detection, options.fit, context, rows);
  if (noise != nullptr) *noise = survey.noise;
  return FindRidges(green, region, laser, survey, options, context);
}

LaserStripes FindRidges(const cv::Mat& green, const cv::Mat& region, int laser, const RidgeSurvey& survey,
                        const RidgeOptions& options, const Context& context) {
  LaserStripes none;
  none.laser = laser;
  if (!(survey.width_px > 0.0)) return none;
  RidgeDetectionOptions detection = options.detection;
  detection.width_px = survey.width_px;
  const auto candidates = DetectRidges(green, region, survey.noise, detection, context);
  std::vector<std::vector<StripePoint>> rows(candidates.size());
  ParallelFor(context, 0, (green.rows + kRowsTogether - 1) / kRowsTogether, [&](std::int64_t block) {
    MeasureRows(green, candidates, static_cast<int>(block) * kRowsTogether, survey, options, &rows);
  });
  const LaserStripes linked = LinkSegments(rows, laser, options.linking);
  const LaserStripes mended =
      MendCutStripes(green, linked, survey.noise, survey.width_px, options.fit, options.cut, context);
  LaserStripes trimmed = TrimEnds(mended, survey.noise, options);
  return options.scale_deviations ? ScaleDeviations(std::move(trimmed)) : trimmed;
}

}  // namespace dorsum
