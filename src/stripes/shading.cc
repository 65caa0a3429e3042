// SPDX-License-Identifier: Apache-2.0
#include "stripes/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/median.h"
#include "base/parallel.h"
#include "stripes/append_segment.h"
#include "stripes/shaded_row.h"

namespace dorsum {
namespace {

// Columns of the stripe points of each row, growing.
std::vector<std::vector<float>> ColumnsByRow(const LaserStripes& stripes, int rows) {
  std::vector<std::vector<float>> columns(static_cast<std::size_t>(rows));
  for (const StripePoint& p : stripes.points) columns[static_cast<std::size_t>(p.v)].push_back(p.u);
  for (std::vector<float>& row : columns) std::sort(row.begin(), row.end());
  return columns;
}

// Of each row of a segment, the median of the rows around it.
std::vector<double> WidthsAlong(const LaserStripes& one, const StripeSegment& segment) {
  constexpr std::int32_t kRows = 7;
  std::vector<double> widths;
  widths.reserve(static_cast<std::size_t>(segment.count));
  std::array<float, 2 * kRows + 1> near{};  // sorted
  auto* end = near.data();
  const auto width = [&](std::int32_t row) {
    return one.points[static_cast<std::size_t>(segment.first + row)].width;
  };
  const auto take = [&](float value) {
    auto* at = std::upper_bound(near.data(), end, value);
    std::move_backward(at, end, end + 1);
    *at = value;
    ++end;
  };
  for (std::int32_t row = 0; row < std::min(kRows, segment.count); ++row) take(width(row));
  for (std::int32_t row = 0; row < segment.count; ++row) {
    if (row > kRows) {
      auto* at = std::lower_bound(near.data(), end, width(row - kRows - 1));
      std::move(at + 1, end, at);
      --end;
    }
    if (row + kRows < segment.count) take(width(row + kRows));
    widths.push_back(static_cast<double>(near[static_cast<std::size_t>(end - near.data()) / 2]));
  }
  return widths;
}

// Whole rows first; then those that an edge cuts, with what the whole ones say. `fit`: fits some rows.
template <class Fit>
std::vector<ShadedRow> FitTwice(const LaserStripes& one, const StripeSegment& segment,
                                const std::vector<double>& widths, const Fit& fit) {
  std::vector<ShadedRowTask> tasks;
  tasks.reserve(widths.size());
  for (std::size_t i = 0; i < widths.size(); ++i) {
    tasks.push_back({one.points[static_cast<std::size_t>(segment.first) + i], widths[i], std::nullopt});
  }
  std::vector<ShadedRow> rows = fit(tasks);
  std::vector<ShadedRowTask> again;
  std::vector<std::size_t> cut;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto whole = rows[i].cut ? WholeRowsAround(rows, i) : std::nullopt;
    if (!whole) continue;
    cut.push_back(i);
    again.push_back({tasks[i].point, widths[i], whole});
  }
  const std::vector<ShadedRow> better = fit(again);
  for (std::size_t k = 0; k < cut.size(); ++k) rows[cut[k]] = better[k];
  return rows;
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

}  // namespace

void FitOnShadedSurface(const SurfaceBrightness& brightness, const std::vector<LaserPicture>& pictures,
                        const ProfileFitOptions& fit, const ShadingOptions& options, const Context& context,
                        IndexedStripes* stripes) {
  ParallelFor(context, 0, static_cast<std::int64_t>(stripes->lasers.size()), [&](std::int64_t laser) {
    const auto k = static_cast<std::size_t>(laser);
    LaserStripes& one = stripes->lasers[k];
    const LaserPicture& picture = pictures[k];
    const double usual_width = MedianWidth(one);
    const auto columns = ColumnsByRow(one, picture.green.rows);
    std::vector<StripePoint> points = one.points;
    std::vector<char> keep(points.size(), 1);
    ParallelFor(context, 0, static_cast<std::int64_t>(one.segments.size()), [&](std::int64_t n) {
      const StripeSegment& segment = one.segments[static_cast<std::size_t>(n)];
      if (!segment.order) return;
      const std::optional<double> strength = brightness.StrengthOf(one.laser, *segment.order);
      const std::vector<double> widths = WidthsAlong(one, segment);
      const std::vector<ShadedRow> rows =
          FitTwice(one, segment, widths, [&](const std::vector<ShadedRowTask>& tasks) {
            return FitShadedRows(tasks, brightness, picture, columns, fit, options.row);
          });
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t at = static_cast<std::size_t>(segment.first) + i;
        const StripePoint& measured = one.points[at];
        StripePoint& point = points[at];
        if (rows[i].moved) {
          point.u = static_cast<float>(rows[i].profile.u);
          point.sd_px = static_cast<float>(rows[i].profile.sd_u);
        }
        const auto ratio = strength ? brightness.RatioOf(*strength, measured, widths[i]) : std::nullopt;
        const auto sd = static_cast<double>(point.sd_px);
        const bool flank = IsFlankOnly(ratio, measured, sd, widths[i], usual_width, options);
        keep[at] = rows[i].measures && !flank ? 1 : 0;
      }
    });
    one.points = std::move(points);
    one = KeepPoints(one, keep);
    UpdateExtremes(&one);
  });
}

}  // namespace dorsum
