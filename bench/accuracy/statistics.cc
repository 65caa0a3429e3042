// SPDX-License-Identifier: Apache-2.0
#include "accuracy/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dorsum::accuracy {

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

double Rms(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

double Mean(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

ErrorStatistics Describe(const std::vector<double>& errors) {
  std::vector<double> magnitudes(errors);
  for (double& e : magnitudes) e = std::abs(e);
  return {Rms(errors), Mean(errors), Quantile(magnitudes, 0.5), Quantile(magnitudes, 0.95)};
}

}  // namespace dorsum::accuracy
