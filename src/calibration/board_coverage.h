// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// Which parts of the picture the chessboards of a series have covered so far: a camera's distortion is known
// only where corners were seen.
class BoardCoverage {
 public:
  static constexpr int kColumns = 8, kRows = 6;

  explicit BoardCoverage(cv::Size picture) : picture_(picture), cells_(kColumns * kRows, false) {}

  void Add(const std::vector<cv::Point2f>& corners);
  bool Covers(int column, int row) const {
    return cells_.at(static_cast<std::size_t>(row * kColumns + column));
  }
  double Share() const;
  // The corner of the picture that has least, in words: "top left"; empty when each has half of its cells.
  std::string Missing() const;

 private:
  cv::Size picture_;
  std::vector<bool> cells_;
};

// Whether two views of a board are as good as the same: their corners lie less than `min_px` apart on
// average.
bool SameView(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b, double min_px);

}  // namespace dorsum
