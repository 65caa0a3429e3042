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
  int seen = 0, clipped = 0, darkest = fit->first, brightest = fit->first;
  int low = 256, high = -1;
  for (int x = fit->first; x <= fit->last; ++x) {
    if (!(start.GainAt(x) > 0.0F)) continue;
    const int grey = row[x];
    if (grey < low) {
      low = grey;
      darkest = x;
    }
    if (grey > high) {
      high = grey;
      brightest = x;
    }
    ++seen;
    clipped += grey >= options.saturated_grey ? 1 : 0;
  }
  fit->clipped = clipped;
  if (seen == 0) return 0;
  const double most = high / std::max(0.5, static_cast<double>(start.GainAt(brightest)));
  fit->background = std::min(low / std::max(0.2, static_cast<double>(start.GainAt(darkest))), most);
  fit->amplitude = std::max(1.0, most - fit->background + (clipped > 0 ? 20.0 : 0.0));
  return seen;
}

}  // namespace dorsum
