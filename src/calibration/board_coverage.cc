// SPDX-License-Identifier: Apache-2.0
#include "calibration/board_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dorsum {

void BoardCoverage::Add(const std::vector<cv::Point2f>& corners) {
  for (const cv::Point2f& p : corners) {
    const float column = std::floor(p.x * kColumns / static_cast<float>(picture_.width));
    const float row = std::floor(p.y * kRows / static_cast<float>(picture_.height));
    if (!(column >= 0.0F && row >= 0.0F && column < kColumns && row < kRows)) continue;
    cells_[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)] = true;
  }
}

double BoardCoverage::Share() const {
  return static_cast<double>(std::count(cells_.begin(), cells_.end(), true)) /
         static_cast<double>(cells_.size());
}

std::string BoardCoverage::Missing() const {
  constexpr std::array<const char*, 4> kNames = {"top left", "top right", "bottom left", "bottom right"};
  std::array<int, 4> covered{};
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int corner = (row >= kRows / 2 ? 2 : 0) + (column >= kColumns / 2 ? 1 : 0);
      covered.at(static_cast<std::size_t>(corner)) += Covers(column, row) ? 1 : 0;
    }
  }
  const auto least =
      static_cast<std::size_t>(std::min_element(covered.begin(), covered.end()) - covered.begin());
  if (8 * covered.at(least) >= kColumns * kRows) return {};
  return kNames.at(least);
}

bool SameView(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b, double min_px) {
  if (a.size() != b.size() || a.empty()) return false;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += cv::norm(a[i] - b[i]);
  return sum < min_px * static_cast<double>(a.size());
}

}  // namespace dorsum
