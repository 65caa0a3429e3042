// SPDX-License-Identifier: Apache-2.0
#include "imaging/pieces.h"

#include <algorithm>

namespace dorsum {

Pieces::Pieces(const cv::Mat& mask, std::uint8_t value) {
  std::size_t above = 0, row = 0;
  for (int v = 0; v < mask.rows; ++v) {
    FindRuns(mask, value, v);
    JoinRows(above, row, runs_.size());
    above = row;
    row = runs_.size();
  }
  NumberPieces();
}

void Pieces::FindRuns(const cv::Mat& mask, std::uint8_t value, int v) {
  const auto *row = mask.ptr<std::uint8_t>(v), *end = row + mask.cols;
  for (const auto* first = std::find(row, end, value); first != end;) {
    const auto* last = std::find_if(first, end, [&](std::uint8_t m) { return m != value; });
    const int run = static_cast<int>(runs_.size());
    runs_.push_back({v, static_cast<int>(first - row), static_cast<int>(last - row), run});
    parent_.push_back(run);
    first = std::find(last, end, value);
  }
}

// Joins the runs of a row (row to end - 1) with those above it (above to row - 1).
void Pieces::JoinRows(std::size_t above, std::size_t row, std::size_t end) {
  for (std::size_t upper = above, lower = row; upper < row && lower < end;) {
    const Run &a = runs_[upper], &b = runs_[lower];
    if (a.first < b.end && b.first < a.end) {
      const int root = Root(static_cast<int>(upper)), other = Root(static_cast<int>(lower));
      parent_[static_cast<std::size_t>(std::max(root, other))] = std::min(root, other);
    }
    (a.end < b.end ? upper : lower)++;
  }
}

int Pieces::Root(int run) {
  for (int up = parent_[static_cast<std::size_t>(run)]; up != run;
       up = parent_[static_cast<std::size_t>(run)]) {
    run = parent_[static_cast<std::size_t>(run)] = parent_[static_cast<std::size_t>(up)];
  }
  return run;
}

// A root is its piece's first run.
void Pieces::NumberPieces() {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const int root = Root(static_cast<int>(i));
    runs_[i].piece = root == static_cast<int>(i) ? count_++ : runs_[static_cast<std::size_t>(root)].piece;
  }
}

}  // namespace dorsum
