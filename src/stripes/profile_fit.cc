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
  int seen = 0, clipped = 0;
  float low = 1e9F, high = 0.0F;
  if (start.gain == nullptr) {
    int darkest = 255, brightest = 0;
    for (int x = fit->first; x <= fit->last; ++x) {
      const int grey = row[x];
      darkest = std::min(darkest, grey);
      brightest = std::max(brightest, grey);
      clipped += grey >= options.saturated_grey ? 1 : 0;
    }
    seen = std::max(0, fit->last + 1 - fit->first);
    if (seen > 0) low = static_cast<float>(darkest);
    high = static_cast<float>(brightest);
  } else {
    const float* gains = start.gain - start.first;
    for (int x = fit->first; x <= fit->last; ++x) {
      const float gain = gains[x], share = gain > 0.0F ? 1.0F / gain : 0.0F, grey = row[x];
      low = std::min(low, gain > 0.0F ? grey * std::min(5.0F, share) : 1e9F);
      high = std::max(high, grey * std::min(2.0F, share));
      seen += gain > 0.0F ? 1 : 0;
      clipped += gain > 0.0F && row[x] >= options.saturated_grey ? 1 : 0;
    }
  }
  fit->clipped = clipped;
  const auto most = static_cast<double>(high);
  fit->background = std::min(static_cast<double>(low), most);
  fit->amplitude = std::max(1.0, most - fit->background + (clipped > 0 ? 20.0 : 0.0));
  return seen;
}

}  // namespace dorsum
