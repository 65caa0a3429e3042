// SPDX-License-Identifier: Apache-2.0
#include "stripes/pooling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/parallel.h"
#include "stripes/append_segment.h"
#include "stripes/local_polynomial.h"
#include "stripes/row_noise.h"

namespace dorsum {
namespace {

std::vector<int> WindowSizes(const PoolingOptions& options) {
  std::vector<int> sizes;
  for (double half = options.min_half_rows; half <= options.max_half_rows; half *= 1.4) {
    sizes.push_back(static_cast<int>(std::lround(half)));
  }
  return sizes;
}

// The widest window whose estimate does not contradict those of all narrower ones.
struct Choice {
  LocalEstimate estimate;
  int half_rows = 0;
};

// A wider window holds the narrower one's rows, so the difference of their estimates has about the difference
// of their variances (Hausman 1978), far less than either where they share most of the noise.
bool Agree(const LocalEstimate& wide, const LocalEstimate& narrow, double confidence) {
  const double narrow_variance = narrow.sd * narrow.sd;
  const double variance = std::max(narrow_variance - wide.sd * wide.sd, 0.1 * narrow_variance);
  const double apart = wide.u - narrow.u;
  return apart * apart <= confidence * confidence * variance;
}

Choice ChooseWindow(const StripeCurve& curve, std::size_t k, const std::vector<int>& sizes,
                    const RowNoise& noise, double scale, double confidence,
                    std::vector<LocalEstimate>* tried) {
  Choice choice;
  tried->clear();
  LocalQuadratic window(curve, k);
  for (const int half : sizes) {
    const auto h = static_cast<std::size_t>(half);
    const std::size_t first = k > h ? k - h : 0, last = std::min(curve.v.size() - 1, k + h);
    window.Widen(first, last);
    LocalEstimate fit = window.Estimate(noise.correlation);
    if (!fit.ok) continue;
    fit.sd *= scale;
    bool agrees = true;
    for (const LocalEstimate& narrow : *tried) agrees = agrees && Agree(fit, narrow, confidence);
    if (!agrees) break;
    tried->push_back(fit);
    choice = {fit, half};
    if (first == 0 && last + 1 == curve.v.size()) break;
  }
  return choice;
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
    std::vector<LocalEstimate> tried;
    const auto from = stripes.points.begin() + stripes.segments[i].first;
    const std::vector<double> pull =
        BrightnessPull(std::vector<StripePoint>(from, from + stripes.segments[i].count), options.pull);
    const auto first = static_cast<std::size_t>(options.first_row);
    const auto step = static_cast<std::size_t>(options.every_rows);
    for (std::size_t k = first; k < curve.v.size(); k += step) {
      const Choice choice =
          ChooseWindow(curve, k, sizes, noise, noise.per_curve[i], options.confidence, &tried);
      StripePoint& p = stripes.points[static_cast<std::size_t>(stripes.segments[i].first) + k];
      p.row_u = p.u;
      p.row_sd_px = static_cast<float>(std::hypot(curve.sd[k] * noise.per_curve[i] * alike, pull[k]));
      if (choice.half_rows == 0) continue;
      p.u = static_cast<float>(choice.estimate.u);
      p.sd_px = static_cast<float>(std::hypot(options.choice_error * choice.estimate.sd, pull[k]));
    }
  });
  UpdateExtremes(&stripes);
  return stripes;
}

}  // namespace dorsum
