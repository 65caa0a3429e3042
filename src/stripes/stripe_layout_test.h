// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>

#include "stripes/stripes.h"

namespace dorsum {

// Appends a stripe through rows [from, to) with the column that `u` gives for a row.
inline void AddStripe(LaserStripes* stripes, int from, int to, const std::function<double(int row)>& u,
                      double peak = 100.0) {
  StripeSegment s;
  s.first = static_cast<std::int32_t>(stripes->points.size());
  s.count = to - from;
  s.min_u = s.max_u = static_cast<float>(u(from));
  s.min_v = static_cast<float>(from);
  s.max_v = static_cast<float>(to - 1);
  s.mean_peak = static_cast<float>(peak);
  for (int row = from; row < to; ++row) {
    StripePoint p;
    p.u = static_cast<float>(u(row));
    p.v = static_cast<float>(row);
    p.sd_px = 0.3F;
    p.peak = static_cast<float>(peak);
    p.segment = static_cast<std::int32_t>(stripes->segments.size());
    s.min_u = std::min(s.min_u, p.u);
    s.max_u = std::max(s.max_u, p.u);
    stripes->points.push_back(p);
  }
  stripes->segments.push_back(s);
}

// An upright stripe.
inline void AddStripe(LaserStripes* stripes, int from, int to, double u, double peak = 100.0) {
  AddStripe(
      stripes, from, to, [u](int) { return u; }, peak);
}

}  // namespace dorsum
