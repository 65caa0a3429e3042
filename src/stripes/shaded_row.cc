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
  const auto [least, most] = std::minmax_element(start.gain + first, start.gain + last + 1);
  return {*least, *most};
}

bool IsOnDarkSide(const ProfileFit& fit, const ProfileStart& start, const ShadedRowOptions& options) {
  const auto bright = static_cast<double>(GainAround(start, fit.u, fit.width).most);
  for (const double beside : {-options.edge_px, 0.0, options.edge_px}) {
    const int x = std::clamp(static_cast<int>(std::lround(fit.u + beside)), start.first, start.last);
    const auto here = static_cast<double>(start.gain[x]);
    if (here > 0.0 && here < options.dark_side * bright) return true;
  }
  return false;
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

ShadedRowFitter::ShadedRowFitter(const SurfaceBrightness& brightness, const LaserPicture& picture,
                                 const std::vector<std::vector<float>>& columns, const ProfileFitOptions& fit,
                                 const ShadedRowOptions& options)
    : brightness_(brightness),
      picture_(picture),
      columns_(columns),
      fit_(fit),
      options_(options),
      gain_(static_cast<std::size_t>(picture.green.cols), 0.0F) {}

ShadedRow ShadedRowFitter::Fit(const StripePoint& point, double width,
                               const std::optional<WholeRows>& whole) {
  const int v = static_cast<int>(point.v);
  ShadedRow out;
  ProfileStart start;
  start.u = static_cast<double>(point.u);
  start.width = whole ? whole->width : width;
  SetReach(columns_[static_cast<std::size_t>(v)], point.u, start.width, picture_.green.cols, &start);
  if (start.last - start.first < 4) return out;
  const auto level = brightness_.Along(start.u, v, start.first, start.last, gain_.data());
  start.gain = gain_.data();
  const GainRange around = GainAround(start, start.u, start.width);
  // Without one flank, the row cannot tell the profile's width.
  start.hold_width = around.least == 0.0F || whole;
  if (whole && level) {
    start.amplitude = std::exp(*level + whole->strength);
    start.amplitude_sd = whole->share * start.amplitude;
  }
  out.profile = FitProfile(picture_.green.ptr<std::uint8_t>(v), start, picture_.noise, fit_);
  const ProfileFit& fit = out.profile;
  out.cut = static_cast<double>(around.least) < options_.cut * static_cast<double>(around.most);
  if (!fit.ok || std::abs(fit.u - start.u) > options_.max_move * start.width) return out;
  out.moved = true;
  out.measures = !IsOnDarkSide(fit, start, options_) && fit.sd_u <= options_.max_sd * start.width;
  if (level && fit.clipped == 0) out.strength = std::log(fit.amplitude) - *level;
  return out;
}

}  // namespace dorsum
