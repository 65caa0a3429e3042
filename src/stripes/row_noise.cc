// SPDX-License-Identifier: Apache-2.0
#include "stripes/row_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace dorsum {
namespace {

// A curve needs about this many rows before its own scale counts as much as everybody's.
constexpr double kOwnRows = 100.0;
// Formal deviations come from noise seen in the same image; rows that agree better than this share of them do
// so because rounding made them alike.
constexpr double kLeastScale = 0.7;
constexpr std::size_t kProducts = 5;  // rows apart: 0 to 4

using Products = std::array<double, kProducts>;

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Weights of a point's neighbours in local quadratic regression.
struct LocalWeights {
  std::vector<double> residual;   // 1 - smoother
  std::vector<double> curvature;  // of the quadratic
};

LocalWeights WeightsOf(int half) {
  double s0 = 0.0, s2 = 0.0, s4 = 0.0;
  for (int i = -half; i <= half; ++i) {
    s0 += 1.0;
    s2 += 1.0 * i * i;
    s4 += 1.0 * i * i * i * i;
  }
  LocalWeights weights;
  const double d = s0 * s4 - s2 * s2;
  for (int i = -half; i <= half; ++i) {
    weights.residual.push_back((i == 0 ? 1.0 : 0.0) - (s4 - s2 * i * i) / d);
    weights.curvature.push_back((s0 * i * i - s2) / d);
  }
  return weights;
}

// Sums of products of the weights with themselves, 0, 1, … rows apart.
std::vector<double> Autocorrelation(const std::vector<double>& weights) {
  std::vector<double> sums(weights.size(), 0.0);
  for (std::size_t m = 0; m < weights.size(); ++m) {
    for (std::size_t i = 0; i + m < weights.size(); ++i) sums[m] += weights[i] * weights[i + m];
  }
  return sums;
}

// Covariances of residuals 0 to 4 rows apart when the errors have unit variance and this correlation.
// `apart`: the autocorrelation of the residual's weights.
Products ExpectedProducts(const std::vector<double>& apart, const RowCorrelation& correlation) {
  const int n = static_cast<int>(apart.size());
  std::vector<double> at(apart.size() + kProducts, 1.0);
  double power = 1.0;
  for (std::size_t rows = 1; rows < at.size(); ++rows) {
    power *= correlation.decay;
    at[rows] = correlation.share * power;
  }
  Products expected{};
  for (int m = 1 - n; m < n; ++m) {
    const double g = apart[static_cast<std::size_t>(std::abs(m))];
    for (int k = 0; k < static_cast<int>(kProducts); ++k) {
      expected[static_cast<std::size_t>(k)] += g * at[static_cast<std::size_t>(std::abs(m - k))];
    }
  }
  return expected;
}

// Residuals over formal deviations, NaN where the window is not whole, and how curved the stripe is there.
struct Residuals {
  std::vector<double> z, curvature;
};

Residuals ResidualsOf(const StripeCurve& curve, const LocalWeights& weights) {
  const std::size_t n = weights.residual.size(), half = n / 2;
  Residuals out;
  out.z.assign(curve.v.size(), NAN);
  out.curvature.assign(curve.v.size(), NAN);
  for (std::size_t k = half; k + half < curve.v.size(); ++k) {
    if (curve.v[k + half] - curve.v[k - half] > 2.0 * static_cast<double>(half) + 0.5) continue;
    double residual = 0.0, bend = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      residual += weights.residual[i] * curve.u[k - half + i];
      bend += weights.curvature[i] * (curve.u[k - half + i] - curve.u[k]);
    }
    out.z[k] = residual / curve.sd[k];
    out.curvature[k] = std::abs(bend);
  }
  return out;
}

double RobustSize(const Residuals& residuals, double max_curvature) {
  std::vector<double> sizes;
  for (std::size_t k = 0; k < residuals.z.size(); ++k) {
    if (residuals.curvature[k] <= max_curvature) sizes.push_back(std::abs(residuals.z[k]));
  }
  return Quantile(std::move(sizes), 0.5) / 0.6745;
}

// Mean products of the straighter points' residuals; far-off ones are left out.
Products ObservedProducts(const std::vector<Residuals>& all, const std::vector<double>& scales,
                          double max_curvature) {
  Products sums{}, counts{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<double>& z = all[i].z;
    const double limit = 3.5 * scales[i], unit = 1.0 / (scales[i] * scales[i]);
    for (std::size_t k = 0; k < z.size(); ++k) {
      if (!(all[i].curvature[k] <= max_curvature && std::abs(z[k]) < limit)) continue;
      for (std::size_t lag = 0; lag < kProducts && k + lag < z.size(); ++lag) {
        if (!(std::abs(z[k + lag]) < limit)) continue;
        sums[lag] += z[k] * z[k + lag] * unit;
        counts[lag] += 1.0;
      }
    }
  }
  for (std::size_t lag = 0; lag < kProducts; ++lag)
    sums[lag] = counts[lag] > 0.0 ? sums[lag] / counts[lag] : 0.0;
  return sums;
}

RowCorrelation CorrelationOf(const std::vector<double>& apart, const Products& observed) {
  RowCorrelation best;
  if (!(observed[0] > 0.0)) return best;
  double least = INFINITY;
  for (double share = 0.0; share < 1.55; share += 0.05) {
    for (double decay = 0.2; decay < 0.86; decay += 0.02) {
      if (share * decay > 0.92) continue;
      const RowCorrelation trial{share, decay};
      const Products expected = ExpectedProducts(apart, trial);
      double miss = 0.0;
      for (std::size_t k = 1; k < kProducts; ++k) {
        const double apart_by = expected[k] / expected[0] - observed[k] / observed[0];
        miss += apart_by * apart_by;
      }
      if (miss < least) {
        least = miss;
        best = trial;
      }
      if (share == 0.0) break;  // without a share, the decay says nothing
    }
  }
  return best;
}

}  // namespace

RowNoise MeasureRowNoise(const RowNoiseOptions& options, std::vector<StripeCurve>* curves) {
  const LocalWeights weights = WeightsOf(options.half_rows);
  std::vector<Residuals> residuals;
  std::vector<double> curvatures;
  for (const StripeCurve& curve : *curves) {
    residuals.push_back(ResidualsOf(curve, weights));
    for (const double c : residuals.back().curvature) {
      if (std::isfinite(c)) curvatures.push_back(c);
    }
  }
  RowNoise noise;
  noise.per_curve.assign(curves->size(), 1.0);
  if (curvatures.size() < 30) return noise;
  const double straight = Quantile(std::move(curvatures), 0.5);
  std::vector<double> sizes, scales;
  for (const Residuals& r : residuals) {
    for (std::size_t k = 0; k < r.z.size(); ++k) {
      if (r.curvature[k] <= straight) sizes.push_back(std::abs(r.z[k]));
    }
  }
  const double usual = Quantile(std::move(sizes), 0.5) / 0.6745;
  if (!(usual > 0.0)) return noise;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const double own = RobustSize(residuals[i], straight);
    double n = 0.0;
    for (const double c : residuals[i].curvature) n += c <= straight ? 1.0 : 0.0;
    scales.push_back(std::sqrt((n * own * own + kOwnRows * usual * usual) / (n + kOwnRows)));
    for (std::size_t k = 0; k < residuals[i].z.size(); ++k) {
      if (std::abs(residuals[i].z[k]) > options.outlier_sd * scales[i]) (*curves)[i].use[k] = 0;
    }
  }
  const std::vector<double> apart = Autocorrelation(weights.residual);
  noise.correlation = CorrelationOf(apart, ObservedProducts(residuals, scales, straight));
  const double seen = std::sqrt(ExpectedProducts(apart, noise.correlation)[0]);
  noise.scale = std::max(kLeastScale, usual / seen);
  for (std::size_t i = 0; i < scales.size(); ++i)
    noise.per_curve[i] = std::max(kLeastScale, scales[i] / seen);
  return noise;
}

}  // namespace dorsum
