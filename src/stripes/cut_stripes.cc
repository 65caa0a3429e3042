// SPDX-License-Identifier: Apache-2.0
#include "stripes/cut_stripes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "stripes/profile_flanks.h"
#include "stripes/segment_linking.h"

namespace dorsum {
namespace {

double Quantile(std::vector<double> values, double share) {
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Width at half the peak where the segment is whole: more than half of its rows may be cut. A
// short segment may be cut throughout; there, twice the longer flank tells, or the image's usual width.
constexpr double kLeastOfUsual = 0.88;  // a longer segment is hardly narrower than the others

double WholeWidth(const std::vector<ProfileFlanks>& flanks, double usual) {
  const bool is_short = flanks.size() < 40;
  std::vector<double> widths;
  widths.reserve(flanks.size());
  for (const ProfileFlanks& f : flanks)
    widths.push_back(is_short ? 2.0 * std::max(f.left, f.right) : f.left + f.right);
  const double width = Quantile(std::move(widths), is_short ? 0.5 : 0.6);
  return std::max(width, is_short ? usual : kLeastOfUsual * usual);
}

bool IsCut(const ProfileFlanks& f, double whole, const CutStripeOptions& options) {
  const double ratio = std::min(f.left, f.right) / std::max(f.left, f.right);
  const double width = (f.left + f.right) / whole;
  return ratio < options.steep_flank_ratio ||
         (ratio < options.max_flank_ratio && width < options.max_width_ratio);
}

// Whether the run of rows [first, end) reaches an end of the segment and grows dim towards it.
bool FadesOut(const std::vector<StripePoint>& points, std::size_t first, std::size_t end,
              const CutStripeOptions& options) {
  constexpr std::size_t kRows = 6;
  if (end - first < 2 * kRows) return false;
  const auto mean = [&](std::size_t from) {
    double sum = 0.0;
    for (std::size_t i = from; i < from + kRows; ++i) sum += static_cast<double>(points[i].peak);
    return sum;
  };
  const double head = mean(first), tail = mean(end - kRows);
  return (first == 0 && head < options.fading_ratio * tail) ||
         (end == points.size() && tail < options.fading_ratio * head);
}

// -1: the left flank is cut; 1: the right; 0: none. Runs of narrow rows are judged together: one cut row
// makes the run a cut, and all its rows say on which side.
std::vector<int> CutSides(const std::vector<StripePoint>& points, const std::vector<ProfileFlanks>& flanks,
                          double whole, const CutStripeOptions& options) {
  std::vector<int> cut(flanks.size(), 0);
  const auto is_narrow = [&](std::size_t i) {
    return flanks[i].left + flanks[i].right <= options.whole_width_ratio * whole ||
           IsCut(flanks[i], whole, options);
  };
  for (std::size_t first = 0; first < flanks.size(); ++first) {
    std::size_t end = first;
    bool is_cut = false, is_slim = false;
    double side = 0.0;
    for (; end < flanks.size() && is_narrow(end); ++end) {
      is_cut = is_cut || IsCut(flanks[end], whole, options);
      is_slim = is_slim || flanks[end].left + flanks[end].right < options.slim_width_ratio * whole;
      side += std::log(std::max(0.1, flanks[end].left) / std::max(0.1, flanks[end].right));
    }
    const auto rows = static_cast<double>(end - first);
    is_cut = is_cut || (is_slim && std::abs(side) > -std::log(options.leaning_flank_ratio) * rows) ||
             (is_slim && FadesOut(points, first, end, options));
    if (is_cut)
      std::fill(cut.begin() + static_cast<std::ptrdiff_t>(first),
                cut.begin() + static_cast<std::ptrdiff_t>(end), side > 0.0 ? 1 : -1);
    first = std::max(first, end);
  }
  return cut;
}

// Median amplitude of the nearest rows that are not cut, 0 if there are none.
double WholeAmplitude(const std::vector<StripePoint>& points, const std::vector<int>& cut, std::size_t at) {
  constexpr std::size_t kRows = 12;
  std::vector<double> peaks;
  for (std::size_t away = 1; away < points.size() && peaks.size() < kRows; ++away) {
    if (at >= away && cut[at - away] == 0) peaks.push_back(static_cast<double>(points[at - away].peak));
    if (at + away < points.size() && cut[at + away] == 0) {
      peaks.push_back(static_cast<double>(points[at + away].peak));
    }
  }
  return peaks.size() < kRows ? 0.0 : Quantile(std::move(peaks), 0.5);
}

// Fits a row again with the width held; the window never leaves [start.first, start.last].
bool Refit(const cv::Mat& green, const ProfileStart& start, const NoiseModel& noise,
           const ProfileFitOptions& options, StripePoint* point) {
  const auto* row = green.ptr<std::uint8_t>(static_cast<int>(point->v));
  const ProfileFit fit = FitProfile(row, start, noise, options);
  if (!fit.ok) return false;
  point->u = static_cast<float>(fit.u);
  point->sd_px = static_cast<float>(fit.sd_u);
  point->peak = static_cast<float>(std::min(255.0, fit.amplitude));
  point->width = static_cast<float>(fit.width);
  return true;
}

// Fits the intact flank of a cut row; false when the centre is not on the surface.
bool MendPoint(const cv::Mat& green, const ProfileFlanks& flanks, int side, double width, double amplitude,
               const NoiseModel& noise, const ProfileFitOptions& fit_options, const CutStripeOptions& options,
               StripePoint* point) {
  const double u = static_cast<double>(point->u) + flanks.peak;
  const double edge = side > 0 ? u + flanks.right : u - flanks.left;
  ProfileStart start;
  start.u = side > 0 ? edge - 0.5 : edge + 0.5;
  start.width = width;
  start.hold_width = true;
  start.amplitude = amplitude;
  start.amplitude_sd = options.amplitude_share * amplitude;
  start.first = side > 0 ? 0 : static_cast<int>(std::ceil(edge + options.margin_px));
  start.last = side > 0 ? static_cast<int>(std::floor(edge - options.margin_px)) : green.cols - 1;
  if (!Refit(green, start, noise, fit_options, point)) return false;
  const double inside =
      side > 0 ? edge - static_cast<double>(point->u) : static_cast<double>(point->u) - edge;
  return inside >= options.min_inside_px;
}

// The image's border cuts a profile too, but there the light does not end.
bool MendAtBorder(const cv::Mat& green, double width, const NoiseModel& noise,
                  const ProfileFitOptions& fit_options, StripePoint* point) {
  ProfileStart start;
  start.u = static_cast<double>(point->u);
  start.width = width;
  start.hold_width = true;
  start.last = green.cols - 1;
  return Refit(green, start, noise, fit_options, point) && point->u > -0.5F &&
         point->u < static_cast<float>(green.cols) - 0.5F;
}

bool IsAtBorder(const StripePoint& point, double width, int cols) {
  const auto u = static_cast<double>(point.u);
  return std::min(u, cols - 1.0 - u) < 2.0 * width;
}

// Where a stripe leaves the surface sideways, the light that is left beyond is no stripe either: from two bad
// rows on, everything is bad up to the segment's end, as long as it is cut.
void ForgetBeyond(const std::vector<int>& cut, std::vector<char>* good) {
  const std::size_t n = cut.size();
  std::size_t run = 0;
  while (run < n && cut[run] != 0) ++run;
  bool gone = false;
  for (std::size_t i = run; i-- > 0;) {
    gone = gone || ((*good)[i] == 0 && (i == 0 || (*good)[i - 1] == 0));
    if (gone) (*good)[i] = 0;
  }
  run = n;
  while (run > 0 && cut[run - 1] != 0) --run;
  gone = false;
  for (std::size_t i = run; i < n; ++i) {
    gone = gone || ((*good)[i] == 0 && (i + 1 == n || (*good)[i + 1] == 0));
    if (gone) (*good)[i] = 0;
  }
}

}  // namespace

LaserStripes MendCutStripes(const cv::Mat& green, const LaserStripes& stripes, const NoiseModel& noise,
                            double usual_width_px, const ProfileFitOptions& fit,
                            const CutStripeOptions& options, const Context& context) {
  std::vector<std::vector<StripePoint>> segments(stripes.segments.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(segments.size()), [&](std::int64_t n) {
    const StripeSegment& s = stripes.segments[static_cast<std::size_t>(n)];
    const auto first = stripes.points.begin() + s.first;
    const std::vector<StripePoint> points(first, first + s.count);
    const std::vector<ProfileFlanks> flanks = FlanksAlong(green, points, options.half_rows);
    const double whole = WholeWidth(flanks, 2.3548 * usual_width_px);
    const std::vector<int> cut = CutSides(points, flanks, whole, options);
    const double width = whole / 2.3548;
    std::vector<StripePoint>& kept = segments[static_cast<std::size_t>(n)];
    std::vector<char> good(points.size(), 1);
    std::vector<StripePoint> mended = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (IsAtBorder(points[i], width, green.cols)) {
        good[i] = MendAtBorder(green, width, noise, fit, &mended[i]) ? 1 : 0;
      } else if (cut[i] != 0) {
        good[i] = MendPoint(green, flanks[i], cut[i], width, WholeAmplitude(points, cut, i), noise, fit,
                            options, &mended[i])
                      ? 1
                      : 0;
      }
    }
    ForgetBeyond(cut, &good);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (good[i] != 0) kept.push_back(mended[i]);
    }
  });
  return AssembleStripes(segments, stripes.laser);
}

}  // namespace dorsum
