// SPDX-License-Identifier: Apache-2.0
#include "imaging/iterative_threshold.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace dorsum {

double IterativeThreshold(const cv::Mat& image) {
  if (image.type() != CV_8UC1 || image.empty())
    throw std::logic_error("IterativeThreshold: CV_8UC1 expected");
  std::array<std::int64_t, 256> histogram{};
  for (int r = 0; r < image.rows; ++r) {
    const auto* row = image.ptr<std::uint8_t>(r);
    for (int c = 0; c < image.cols; ++c) ++histogram[row[c]];
  }
  std::array<double, 257> count{}, sum{};  // of the values below i
  for (std::size_t i = 0; i < 256; ++i) {
    count[i + 1] = count[i] + static_cast<double>(histogram[i]);
    sum[i + 1] = sum[i] + static_cast<double>(histogram[i]) * static_cast<double>(i);
  }
  double threshold = sum[256] / count[256];
  for (int iteration = 0; iteration < 256; ++iteration) {
    const auto split = static_cast<std::size_t>(std::floor(threshold)) + 1;
    const double low = count[split] > 0 ? sum[split] / count[split] : threshold;
    const double above = count[256] - count[split];
    const double high = above > 0 ? (sum[256] - sum[split]) / above : threshold;
    const double next = 0.5 * (low + high);
    if (std::abs(next - threshold) < 0.01) break;
    threshold = next;
  }
  return threshold;
}

}  // namespace dorsum
