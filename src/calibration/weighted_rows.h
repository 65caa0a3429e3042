// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace dorsum {

// Cauchy's loss: what a sum of squares costs, and what its residuals then weigh.
inline double CauchyCost(double square, double scale) {
  return 0.5 * scale * scale * std::log1p(square / (scale * scale));
}
inline double CauchyWeight(double square, double scale) { return 1.0 / (1.0 + square / (scale * scale)); }

// Weighted rows of derivatives with the residual behind them, gathered before their products are summed.
// Columns before `from` do not move.
template <int kColumns>
class WeightedRows {
 public:
  explicit WeightedRows(int from) : from_(from) {}

  template <class Derivatives>
  void Add(const Derivatives& derivatives, double factor, double residual, Eigen::MatrixXd* squares) {
    for (int i = from_; i < kColumns; ++i) rows_(count_, i) = factor * derivatives[i];
    rows_(count_, kColumns) = residual;
    if (++count_ == kRows) Flush(squares);
  }
  void Flush(Eigen::MatrixXd* squares) {
    const int width = kColumns + 1 - from_;
    squares->bottomRightCorner(width, width)
        .template selfadjointView<Eigen::Lower>()
        .rankUpdate(rows_.topRows(count_).rightCols(width).transpose());
    count_ = 0;
  }

 private:
  static constexpr int kRows = 128;
  Eigen::Matrix<double, kRows, kColumns + 1, Eigen::RowMajor> rows_;
  int from_, count_ = 0;
};

}  // namespace dorsum
