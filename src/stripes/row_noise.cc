// SPDX-License-Identifier: Apache-2.0
#include "stripes/row_noise.h"

#include <algorithm>
#include <cmath>

namespace dorsum {
namespace {

// A curve needs about this many rows before its own scale counts as much as everybody's.
constexpr double kOwnRows = 60.0;

double MedianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Residuals over formal deviations; NaN where there is none.
std::vector<double> Residuals(const StripeCurve& curve, const std::vector<int>& half_rows) {
  RowCorrelation white{};
  white[0] = 1.0;
  std::vector<double> z(curve.v.size(), NAN);
  for (std::size_t k = 0; k < z.size(); ++k) {
    const auto half = static_cast<std::size_t>(half_rows[k]);
    const std::size_t first = k > half ? k - half : 0, last = std::min(z.size() - 1, k + half);
    const LocalEstimate fit = FitLocally(curve, first, last, curve.v[k], white);
    if (!fit.ok) continue;
    // The point has a share in its own estimate.
    const double share = curve.use[k] != 0 ? std::pow(fit.sd / curve.sd[k], 2.0) : 0.0;
    z[k] = (curve.u[k] - fit.u) / curve.sd[k] / std::sqrt(std::max(0.2, 1.0 - share));
  }
  return z;
}

}  // namespace

RowNoise MeasureRowNoise(const std::vector<std::vector<int>>& half_rows, double outlier_sd,
                         std::vector<StripeCurve>* curves) {
  RowNoise noise;
  std::vector<std::vector<double>> z(curves->size());
  std::vector<double> sizes;
  for (std::size_t i = 0; i < curves->size(); ++i) {
    z[i] = Residuals((*curves)[i], half_rows[i]);
    for (const double value : z[i]) {
      if (std::isfinite(value)) sizes.push_back(std::abs(value));
    }
  }
  if (sizes.size() > 20) noise.scale = std::clamp(MedianOf(sizes) / 0.6745, 0.3, 20.0);
  RowCorrelation products{}, counts{};
  for (std::size_t i = 0; i < curves->size(); ++i) {
    StripeCurve& curve = (*curves)[i];
    std::vector<double> own;
    for (const double value : z[i]) {
      if (std::isfinite(value)) own.push_back(std::abs(value));
    }
    const double robust = MedianOf(own) / 0.6745;
    const auto n = static_cast<double>(own.size());
    const double scale =
        std::sqrt((n * robust * robust + kOwnRows * noise.scale * noise.scale) / (n + kOwnRows));
    noise.per_curve.push_back(scale);
    for (std::size_t k = 0; k < z[i].size(); ++k) {
      const bool fits = std::isfinite(z[i][k]) && std::abs(z[i][k]) <= outlier_sd * scale;
      if (std::isfinite(z[i][k])) curve.use[k] = fits ? 1 : 0;
      if (!fits) z[i][k] = NAN;
    }
    for (std::size_t k = 0; k < z[i].size(); ++k) {
      for (std::size_t lag = 0; lag < kLags && k + lag < z[i].size(); ++lag) {
        const double product = z[i][k] * z[i][k + lag];
        if (!std::isfinite(product) || curve.v[k + lag] - curve.v[k] > static_cast<double>(lag) + 0.5)
          continue;
        products[lag] += product / (scale * scale);
        counts[lag] += 1.0;
      }
    }
  }
  noise.correlation[0] = 1.0;
  for (std::size_t lag = 1; lag < kLags; ++lag) {
    if (counts[lag] < 50.0 || products[0] <= 0.0) continue;
    const double r = (products[lag] / counts[lag]) / (products[0] / counts[0]);
    // Once the correlation has died away, what is left is chance and the fit's own trace.
    if (r < 0.03) break;
    noise.correlation[lag] = std::min(r, 0.95);
  }
  return noise;
}

}  // namespace dorsum
