// SPDX-License-Identifier: Apache-2.0
#include "stripes/shading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/median.h"
#include "base/parallel.h"
#include "stripes/append_segment.h"

namespace dorsum {
namespace {

// Columns of the stripe points of each row, growing.
std::vector<std::vector<float>> ColumnsByRow(const LaserStripes& stripes, int rows) {
  std::vector<std::vector<float>> columns(static_cast<std::size_t>(rows));
  for (const StripePoint& p : stripes.points) columns[static_cast<std::size_t>(p.v)].push_back(p.u);
  for (std::vector<float>& row : columns) std::sort(row.begin(), row.end());
  return columns;
}

double WidthAround(const LaserStripes& one, const StripeSegment& segment, std::int32_t at) {
  constexpr std::int32_t kRows = 7;
  std::vector<float> widths;
  for (std::int32_t i = std::max(segment.first, at - kRows);
       i < std::min(segment.first + segment.count, at + kRows + 1); ++i) {
    widths.push_back(one.points[static_cast<std::size_t>(i)].width);
  }
  return static_cast<double>(Median(std::move(widths)));
}

// The window of a fit: three widths, but not beyond half the way to the neighbours.
void SetReach(const std::vector<float>& row, float u, double width, int cols, ProfileStart* start) {
  const auto centre = static_cast<double>(u);
  double low = centre - 3.0 * width - 1.0, high = centre + 3.0 * width + 1.0;
  const auto next = std::upper_bound(row.begin(), row.end(), u);
  if (next != row.end()) high = std::min(high, 0.5 * (centre + static_cast<double>(*next)));
  const auto before = std::lower_bound(row.begin(), row.end(), u);
  if (before != row.begin()) low = std::max(low, 0.5 * (centre + static_cast<double>(*(before - 1))));
  start->first = std::max(0, static_cast<int>(std::ceil(low)));
  start->last = std::min(cols - 1, static_cast<int>(std::floor(high)));
}

bool IsOnDarkSide(const ProfileFit& fit, const ProfileStart& start, const ShadingOptions& options) {
  const int first = std::max(start.first, static_cast<int>(std::ceil(fit.u - 1.5 * fit.width)));
  const int last = std::min(start.last, static_cast<int>(std::floor(fit.u + 1.5 * fit.width)));
  float brightest = 0.0F;
  for (int x = first; x <= last; ++x) brightest = std::max(brightest, start.gain[x]);
  const int centre = std::clamp(static_cast<int>(std::lround(fit.u)), start.first, start.last);
  const float here = start.gain[centre];
  return here > 0.0F && static_cast<double>(here) < options.dark_side * static_cast<double>(brightest);
}

// Whether the row is so dark, for a surface as bright as this, that it can only be the flank of a stripe
// whose middle misses the surface.
bool IsFlankOnly(const std::optional<double>& ratio, const StripePoint& measured, double sd_px, double width,
                 double usual_width, const ShadingOptions& options) {
  if (!ratio) return false;
  return *ratio < options.dark || (*ratio < options.dim && sd_px > options.vague_sd * width) ||
         (*ratio < options.dusky && static_cast<double>(measured.width) < options.narrow * usual_width);
}

double MedianWidth(const LaserStripes& stripes) {
  std::vector<float> widths;
  widths.reserve(stripes.points.size());
  for (const StripePoint& p : stripes.points) widths.push_back(p.width);
  return static_cast<double>(Median(std::move(widths)));
}

// Whether both flanks are there: without one, the row cannot tell the profile's width.
bool IsSeenAround(const ProfileStart& start, double width) {
  const int first = std::max(start.first, static_cast<int>(std::floor(start.u - 1.5 * width)));
  const int last = std::min(start.last, static_cast<int>(std::ceil(start.u + 1.5 * width)));
  return std::all_of(start.gain + first, start.gain + last + 1, [](float g) { return g > 0.0F; });
}

// False when the point is no measurement of the surface.
bool Refit(const SurfaceBrightness& brightness, const LaserPicture& picture, const std::vector<float>& row,
           double width, const ProfileFitOptions& fit_options, const ShadingOptions& options,
           std::vector<float>* gain, StripePoint* point) {
  const int v = static_cast<int>(point->v);
  ProfileStart start;
  start.u = static_cast<double>(point->u);
  start.width = width;
  SetReach(row, point->u, width, picture.green.cols, &start);
  if (start.last - start.first < 4) return true;
  brightness.Along(start.u, v, start.first, start.last, gain->data());
  start.gain = gain->data();
  start.hold_width = !IsSeenAround(start, width);
  const ProfileFit fit = FitProfile(picture.green.ptr<std::uint8_t>(v), start, picture.noise, fit_options);
  if (!fit.ok || std::abs(fit.u - start.u) > options.max_move * width) return true;
  if (IsOnDarkSide(fit, start, options) || fit.sd_u > options.max_sd * width) return false;
  point->u = static_cast<float>(fit.u);
  point->sd_px = static_cast<float>(fit.sd_u);
  return true;
}

}  // namespace

void FitOnShadedSurface(const SurfaceBrightness& brightness, const std::vector<LaserPicture>& pictures,
                        const ProfileFitOptions& fit, const ShadingOptions& options, const Context& context,
                        IndexedStripes* stripes) {
  for (std::size_t k = 0; k < stripes->lasers.size(); ++k) {
    LaserStripes& one = stripes->lasers[k];
    const LaserPicture& picture = pictures[k];
    const double usual_width = MedianWidth(one);
    const auto columns = ColumnsByRow(one, picture.green.rows);
    std::vector<StripePoint> points = one.points;
    std::vector<char> keep(points.size(), 1);
    ParallelFor(context, 0, static_cast<std::int64_t>(one.segments.size()), [&](std::int64_t n) {
      const StripeSegment& segment = one.segments[static_cast<std::size_t>(n)];
      if (!segment.order) return;
      std::vector<float> gain(static_cast<std::size_t>(picture.green.cols), 0.0F);
      for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const auto& row = columns[static_cast<std::size_t>(points[at].v)];
        const double width = WidthAround(one, segment, i);
        const auto ratio = brightness.RatioOf(one.laser, *segment.order, points[at], width);
        const bool good = Refit(brightness, picture, row, width, fit, options, &gain, &points[at]) &&
                          !IsFlankOnly(ratio, one.points[at], static_cast<double>(points[at].sd_px), width,
                                       usual_width, options);
        keep[at] = good ? 1 : 0;
      }
    });
    one.points = std::move(points);
    one = KeepPoints(one, keep);
    UpdateExtremes(&one);
  }
}

}  // namespace dorsum
