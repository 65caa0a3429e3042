// SPDX-License-Identifier: Apache-2.0
#include "stripes/stripe_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace dorsum {
std::vector<StripeCurve> CurvesOf(const LaserStripes& stripes) {
  std::vector<StripeCurve> curves;
  curves.reserve(stripes.segments.size());
  for (const StripeSegment& segment : stripes.segments) {
    const auto count = static_cast<std::size_t>(segment.count);
    StripeCurve& curve = curves.emplace_back();
    for (auto* values : {&curve.v, &curve.u, &curve.sd}) values->reserve(count);
    curve.use.assign(count, 1);
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
      curve.v.push_back(static_cast<double>(p.v));
      curve.u.push_back(static_cast<double>(p.u));
      curve.sd.push_back(std::max(1e-3, static_cast<double>(p.sd_px)));
    }
  }
  return curves;
}

void MeasureAngles(StripeCurve* curve) {
  const double from = curve->v.front() - 0.5, length = curve->v.back() + 0.5 - from;
  curve->angle.reserve(curve->v.size());
  for (const double v : curve->v) curve->angle.push_back(std::acos(1.0 - 2.0 * (v - from) / length));
}

}  // namespace dorsum
