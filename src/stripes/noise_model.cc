// SPDX-License-Identifier: Apache-2.0
#include "stripes/noise_model.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace dorsum {
namespace {

// One class of grey values.
struct Level {
  double grey = 0.0, variance = 0.0, weight = 0.0;
};

// Mean of the squares without the largest twentieth, put right for a normal distribution: what is cut off
// holds 23.6 % of its variance.
double TrimmedVariance(NoiseSample* first, std::size_t count) {
  const std::size_t kept = std::max<std::size_t>(1, count - count / 20);
  std::nth_element(first, first + (kept - 1), first + count, [](const NoiseSample& p, const NoiseSample& q) {
    return p.squared_residual < q.squared_residual;
  });
  double sum = 0.0;
  for (std::size_t i = 0; i < kept; ++i) sum += static_cast<double>(first[i].squared_residual);
  const double share = kept < count ? 0.764 : 1.0;
  return sum / static_cast<double>(count) / share;
}

// Leaves samples spread evenly over all of them, so many that the variances are known to a hundredth or two.
void Thin(std::vector<NoiseSample>* samples) {
  constexpr std::size_t kEnough = 10000;
  const std::size_t step = (samples->size() + kEnough - 1) / kEnough;
  if (step < 2) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples->size(); i += step) (*samples)[kept++] = (*samples)[i];
  samples->resize(kept);
}

// Orders samples by their grey values so far that the classes [first, last) between `bounds` are right.
void SortIntoClasses(NoiseSample* samples, const std::vector<std::size_t>& bounds, std::size_t first,
                     std::size_t last) {
  if (last - first < 2) return;
  const std::size_t middle = (first + last) / 2;
  std::nth_element(samples + bounds[first], samples + bounds[middle], samples + bounds[last],
                   [](const NoiseSample& p, const NoiseSample& q) { return p.grey < q.grey; });
  SortIntoClasses(samples, bounds, first, middle);
  SortIntoClasses(samples, bounds, middle, last);
}

std::vector<Level> Levels(std::vector<NoiseSample>* samples) {
  const std::size_t classes = std::clamp<std::size_t>(samples->size() / 50, 4, 24);
  std::vector<std::size_t> bounds;
  for (std::size_t k = 0; k <= classes; ++k) bounds.push_back(k * samples->size() / classes);
  SortIntoClasses(samples->data(), bounds, 0, classes);
  std::vector<Level> levels;
  for (std::size_t k = 0; k < classes; ++k) {
    const std::size_t from = bounds[k], to = bounds[k + 1];
    const auto first = samples->begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = samples->begin() + static_cast<std::ptrdiff_t>(to);
    Level level;
    for (auto s = first; s != last; ++s) level.grey += static_cast<double>(s->grey);
    level.grey = std::max(0.0, level.grey / static_cast<double>(to - from));
    level.variance = std::max(kLeastVariance, TrimmedVariance(&*first, to - from));
    level.weight = static_cast<double>(to - from);
    levels.push_back(level);
  }
  return levels;
}

// Weighted least squares of the terms that `use` names, each class weighted by its own relative error.
// Returns the sum of squares, or infinity when a term comes out negative.
double FitTerms(const std::vector<Level>& levels, const std::array<bool, 3>& use,
                std::array<double, 3>* out) {
  std::array<std::array<double, 4>, 3> n{};
  for (const Level& level : levels) {
    const std::array<double, 3> f = {1.0, level.grey, level.grey * level.grey};
    const double w = level.weight / (level.variance * level.variance);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) n[i][j] += w * f[i] * f[j];
      n[i][3] += w * f[i] * level.variance;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (use[i]) continue;
    for (std::size_t j = 0; j < 4; ++j) n[i][j] = n[std::min<std::size_t>(j, 2)][i] = 0.0;
    n[i][3] = 0.0;
    n[i][i] = 1.0;
  }
  for (std::size_t i = 0; i < 3; ++i) {  // Gauss-Jordan; the matrix is positive definite
    if (n[i][i] < 1e-300) return INFINITY;
    for (std::size_t r = 0; r < 3; ++r) {
      if (r == i) continue;
      const double q = n[r][i] / n[i][i];
      for (std::size_t j = i; j < 4; ++j) n[r][j] -= q * n[i][j];
    }
  }
  double error = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    (*out)[i] = n[i][3] / n[i][i];
    if ((*out)[i] < 0.0) return INFINITY;
  }
  for (const Level& level : levels) {
    const double fit = (*out)[0] + level.grey * ((*out)[1] + level.grey * (*out)[2]);
    error += level.weight * std::pow(fit / level.variance - 1.0, 2.0);
  }
  return error;
}

}  // namespace

NoiseModel FitNoiseModel(std::vector<NoiseSample> samples, const NoiseModel& start) {
  if (samples.size() < 200) return start;
  Thin(&samples);
  const std::vector<Level> levels = Levels(&samples);
  double best = INFINITY;
  NoiseModel model = start;
  for (int bits = 1; bits < 8; ++bits) {
    std::array<double, 3> terms{};
    const double error = FitTerms(levels, {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0}, &terms);
    if (error >= best) continue;
    best = error;
    model = {std::max(kLeastVariance, terms[0]), terms[1], terms[2]};
  }
  return model;
}

}  // namespace dorsum
