// SPDX-License-Identifier: Apache-2.0
#include "stripes/shaded_row.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/median.h"

namespace dorsum {
namespace {

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

struct GainRange {
  float least = 0.0F, most = 0.0F;
};

// Within 1.5 widths of a column.
GainRange GainAround(const ProfileStart& start, double u, double width) {
  const int first = std::clamp(static_cast<int>(std::floor(u - 1.5 * width)), start.first, start.last);
  const int last = std::clamp(static_cast<int>(std::ceil(u + 1.5 * width)), first, start.last);
  const auto [least, most] =
      std::minmax_element(start.gain + (first - start.first), start.gain + (last + 1 - start.first));
  return {*least, *most};
}

bool IsOnDarkSide(const ProfileFit& fit, const ProfileStart& start, const ShadedRowOptions& options) {
  const auto bright = static_cast<double>(GainAround(start, fit.u, fit.width).most);
  for (const double beside : {-options.edge_px, 0.0, options.edge_px}) {
    const int x = std::clamp(static_cast<int>(std::lround(fit.u + beside)), start.first, start.last);
    const auto here = static_cast<double>(start.GainAt(x));
    if (here > 0.0 && here < options.dark_side * bright) return true;
  }
  return false;
}

// A row before it is fitted.
struct PreparedRow {
  ProfileStart start;
  std::optional<double> level;  // of the surface, natural logarithm
  GainRange around;
};

// Adds the row's gains to `gains`; none where its window is too narrow.
std::optional<PreparedRow> Prepare(const ShadedRowTask& task, const SurfaceBrightness& brightness,
                                   const std::vector<std::vector<float>>& columns, int cols,
                                   std::vector<float>* gains) {
  const int v = static_cast<int>(task.point.v);
  PreparedRow row;
  ProfileStart& start = row.start;
  start.u = static_cast<double>(task.point.u);
  start.width = task.whole ? task.whole->width : task.width;
  SetReach(columns[static_cast<std::size_t>(v)], task.point.u, start.width, cols, &start);
  if (start.last - start.first < 4) return std::nullopt;
  const std::size_t at = gains->size();
  gains->resize(at + static_cast<std::size_t>(start.last - start.first + 1));
  start.gain = &(*gains)[at];
  row.level = brightness.Along(start.u, v, start.first, start.last, &(*gains)[at]);
  row.around = GainAround(start, start.u, start.width);
  // Without one flank, the row cannot tell the profile's width.
  start.hold_width = row.around.least == 0.0F || task.whole;
  if (task.whole && row.level) {
    start.amplitude = std::exp(*row.level + task.whole->strength);
    start.amplitude_sd = task.whole->share * start.amplitude;
  }
  return row;
}

ShadedRow Judge(const PreparedRow& row, const ProfileFit& fit, const ShadedRowOptions& options) {
  ShadedRow out;
  out.profile = fit;
  out.cut = static_cast<double>(row.around.least) < options.cut * static_cast<double>(row.around.most);
  if (!fit.ok || std::abs(fit.u - row.start.u) > options.max_move * row.start.width) return out;
  out.moved = true;
  out.measures = !IsOnDarkSide(fit, row.start, options) && fit.sd_u <= options.max_sd * row.start.width;
  if (row.level && fit.clipped == 0) out.strength = std::log(fit.amplitude) - *row.level;
  return out;
}

}  // namespace

std::optional<WholeRows> WholeRowsAround(const std::vector<ShadedRow>& rows, std::size_t at) {
  constexpr std::size_t kReach = 160, kWanted = 24, kLeast = 8;
  std::vector<double> strengths, widths;
  for (std::size_t away = 1; away <= kReach && strengths.size() < kWanted; ++away) {
    for (const std::size_t i : {at - away, at + away}) {  // below 0 is far beyond the end
      if (i >= rows.size() || rows[i].cut || !rows[i].measures || !rows[i].strength) continue;
      strengths.push_back(*rows[i].strength);
      widths.push_back(rows[i].profile.width);
    }
  }
  if (strengths.size() < kLeast) return std::nullopt;
  WholeRows whole;
  whole.strength = Median(strengths);
  for (double& s : strengths) s = std::abs(s - whole.strength);
  constexpr double kToSigma = 1.4826;
  whole.share = std::clamp(kToSigma * Median(std::move(strengths)), 0.1, 0.3);
  whole.width = Median(std::move(widths));
  return whole;
}

std::vector<ShadedRow> FitShadedRows(const std::vector<ShadedRowTask>& tasks,
                                     const SurfaceBrightness& brightness, const LaserPicture& picture,
                                     const std::vector<std::vector<float>>& columns,
                                     const ProfileFitOptions& fit, const ShadedRowOptions& options) {
  std::vector<float> gains;
  std::vector<PreparedRow> prepared;
  std::vector<std::size_t> which;  // of the tasks
  constexpr std::size_t kUsualColumns = 16;
  gains.reserve(tasks.size() * kUsualColumns);
  prepared.reserve(tasks.size());
  which.reserve(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto row = Prepare(tasks[i], brightness, columns, picture.green.cols, &gains);
    if (!row) continue;
    prepared.push_back(*row);
    which.push_back(i);
  }
  std::vector<ProfileTask> profiles;
  profiles.reserve(prepared.size());
  const float* gain = gains.data();  // where the gains lie now that there are no more to come
  for (std::size_t k = 0; k < prepared.size(); ++k) {
    ProfileStart& start = prepared[k].start;
    start.gain = gain;
    gain += start.last - start.first + 1;
    profiles.push_back({picture.green.ptr<std::uint8_t>(static_cast<int>(tasks[which[k]].point.v)), start});
  }
  const std::vector<ProfileFit> fits = FitProfiles(profiles, picture.noise, fit);
  std::vector<ShadedRow> rows(tasks.size());
  for (std::size_t k = 0; k < fits.size(); ++k) rows[which[k]] = Judge(prepared[k], fits[k], options);
  return rows;
}

}  // namespace dorsum
