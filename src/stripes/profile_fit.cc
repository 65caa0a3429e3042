// SPDX-License-Identifier: Apache-2.0
#include "stripes/profile_fit.h"

#include <algorithm>
#include <cmath>

namespace dorsum {

double ProfileFit::At(double column) const {
  const double t = (column - u) / width;
  return background + amplitude * std::exp(-0.5 * t * t);
}

int BeginFit(const std::uint8_t* row, const ProfileStart& start, const ProfileFitOptions& options,
             ProfileFit* fit) {
  const double half = std::clamp(options.half_window_sd * start.width, 3.0, 1.0 * kMostHalfWindow);
  fit->u = start.u;
  fit->width = start.width;
  fit->first = std::max(start.first, static_cast<int>(std::ceil(start.u - half)));
  fit->last = std::min(start.last, static_cast<int>(std::floor(start.u + half)));
  int seen = 0;
  double low = 1e9, high = 0.0;
  for (int x = fit->first; x <= fit->last; ++x) {
    const auto gain = static_cast<double>(start.GainAt(x));
    if (gain <= 0.0) continue;
    ++seen;
    low = std::min(low, row[x] / std::max(0.2, gain));
    high = std::max(high, row[x] / std::max(0.5, gain));
    fit->clipped += row[x] >= options.saturated_grey ? 1 : 0;
  }
  fit->background = std::min(low, high);
  fit->amplitude = std::max(1.0, high - fit->background + (fit->clipped > 0 ? 20.0 : 0.0));
  return seen;
}

}  // namespace dorsum
