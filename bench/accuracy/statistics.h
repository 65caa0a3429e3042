// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace dorsum::accuracy {

// The `share` quantile (0 to 1) of values in any order, straight between the two nearest ranks; 0 for none.
double Quantile(std::vector<double> values, double share);

double Rms(const std::vector<double>& values);   // 0 for none
double Mean(const std::vector<double>& values);  // 0 for none

struct ErrorStatistics {
  double rmse = 0.0, bias = 0.0, median_abs = 0.0, p95_abs = 0.0;
};
ErrorStatistics Describe(const std::vector<double>& errors);

}  // namespace dorsum::accuracy
