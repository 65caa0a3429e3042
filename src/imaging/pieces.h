// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// The connected pieces (4 neighbours) of the pixels of `mask` (CV_8UC1) that are `value`, from runs along the
// rows that are joined where they touch (Rosenfeld and Pfaltz 1966).
class Pieces {
 public:
  struct Run {
    int v, first, end;  // pixels first to end - 1 of row v
    int piece;          // 0 up
  };

  Pieces(const cv::Mat& mask, std::uint8_t value);

  const std::vector<Run>& runs() const { return runs_; }  // by row, then from the left
  int count() const { return count_; }

 private:
  void FindRuns(const cv::Mat& mask, std::uint8_t value, int v);
  void JoinRows(std::size_t above, std::size_t row, std::size_t end);
  int Root(int run);
  void NumberPieces();

  std::vector<Run> runs_;
  std::vector<int> parent_;  // of each run: one that it is joined with, or itself
  int count_ = 0;
};

}  // namespace dorsum
