// SPDX-License-Identifier: Apache-2.0
#include "stripes/pooling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/parallel.h"
#include "stripes/append_segment.h"
#include "stripes/row_noise.h"
#include "stripes/stripe_curve.h"
#include "stripes/window_choice.h"

namespace dorsum {
namespace {

std::vector<int> WindowSizes(const PoolingOptions& options) {
  std::vector<int> sizes;
  for (double half = options.min_half_rows; half <= options.max_half_rows; half *= 1.4) {
    sizes.push_back(static_cast<int>(std::lround(half)));
  }
  return sizes;
}

}  // namespace

LaserStripes PoolAlongStripes(LaserStripes stripes, const PoolingOptions& options, const Context& context) {
  std::vector<StripeCurve> curves = CurvesOf(stripes);
  const std::vector<int> sizes = WindowSizes(options);
  const RowNoise noise = MeasureRowNoise(options.noise, &curves);
  // Many rows together know as much as fewer independent ones.
  const double alike = std::sqrt(1.0 + 2.0 * noise.correlation.share * noise.correlation.decay /
                                           (1.0 - noise.correlation.decay));
  ParallelFor(context, 0, static_cast<std::int64_t>(curves.size()), [&](std::int64_t n) {
    const auto i = static_cast<std::size_t>(n);
    StripeCurve& curve = curves[i];
    MeasureAngles(&curve);
    const auto from = stripes.points.begin() + stripes.segments[i].first;
    const std::vector<double> pull =
        BrightnessPull(std::vector<StripePoint>(from, from + stripes.segments[i].count), options.pull);
    const auto first = static_cast<std::size_t>(options.first_row);
    const auto step = static_cast<std::size_t>(options.every_rows);
    const std::vector<WindowChoice> choices = ChooseWindows(curve, first, step,
                                                            {.half_rows = sizes,
                                                             .confidence = options.confidence,
                                                             .scale = noise.per_curve[i],
                                                             .correlation = noise.correlation});
    std::size_t k = first;
    for (const WindowChoice& choice : choices) {
      StripePoint& p = stripes.points[static_cast<std::size_t>(stripes.segments[i].first) + k];
      p.row_u = p.u;
      p.row_sd_px = static_cast<float>(std::hypot(curve.sd[k] * noise.per_curve[i] * alike, pull[k]));
      if (choice.half_rows > 0) {
        p.u = static_cast<float>(choice.u);
        p.sd_px = static_cast<float>(std::hypot(options.choice_error * choice.sd, pull[k]));
      }
      k += step;
    }
  });
  UpdateExtremes(&stripes);
  return stripes;
}

}  // namespace dorsum
