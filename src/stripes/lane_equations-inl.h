// SPDX-License-Identifier: Apache-2.0
// Included once for each instruction set (Highway), by profile_batch.cc.
#if defined(DORSUM_STRIPES_LANE_EQUATIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DORSUM_STRIPES_LANE_EQUATIONS_INL_H_
#undef DORSUM_STRIPES_LANE_EQUATIONS_INL_H_
#else
#define DORSUM_STRIPES_LANE_EQUATIONS_INL_H_
#endif

#include <array>
#include <cstddef>

#include <hwy/highway.h>

#include "stripes/lane_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

// The lower half of a symmetric matrix of the four unknowns (centre, width, amplitude, background) by rows,
// the right side of its equations, and the cost: the negative logarithm of the likelihood, times 2.
struct Equations {
  std::array<V, 10> matrix;
  std::array<V, 4> right;
  V cost;
};

constexpr std::size_t Entry(std::size_t i, std::size_t j) { return i * (i + 1) / 2 + j; }

// Sums over the columns of each lane's window.
class Sums {
 public:
  Sums() {
    e_.matrix.fill(Set(0.0F));
    e_.right.fill(Set(0.0F));
    e_.cost = Set(0.0F);
    product_ = Set(1.0F);
  }

  HWY_INLINE void Add(const std::array<V, 4>& jacobian, V residual, V variance, M seen) {
    const V weight = hn::IfThenElseZero(seen, Set(1.0F) / variance);
    for (std::size_t i = 0; i < 4; ++i) {
      const V wj = weight * jacobian[i];
      for (std::size_t j = 0; j <= i; ++j) e_.matrix[Entry(i, j)] = e_.matrix[Entry(i, j)] + wj * jacobian[j];
      e_.right[i] = e_.right[i] + wj * residual;
    }
    e_.cost = e_.cost + weight * residual * residual;
    // The weights move with the model, so the cost holds their logarithm too.
    product_ = product_ * hn::IfThenElse(seen, variance, Set(1.0F));
    if (++factors_ == 8) Close();
  }

  void Close() {
    e_.cost = e_.cost + Log(product_);
    product_ = Set(1.0F);
    factors_ = 0;
  }

  Equations& equations() { return e_; }

 private:
  Equations e_;
  V product_;
  int factors_ = 0;
};

// The Cholesky factor of each lane's matrix, in place, with the reciprocals of its diagonal; false where the
// matrix is not positive definite.
HWY_INLINE M Factorise(std::array<V, 10>* matrix) {
  std::array<V, 10>& a = *matrix;
  M good = hn::Eq(Set(0.0F), Set(0.0F));
  for (std::size_t i = 0; i < 4; ++i) {
    const V whole = a[Entry(i, i)];
    for (std::size_t j = 0; j < i; ++j) {
      V sum = a[Entry(i, j)];
      for (std::size_t k = 0; k < j; ++k) sum = sum - a[Entry(i, k)] * a[Entry(j, k)];
      a[Entry(i, j)] = sum * a[Entry(j, j)];
    }
    V sum = whole;
    for (std::size_t k = 0; k < i; ++k) sum = sum - a[Entry(i, k)] * a[Entry(i, k)];
    good = hn::And(good, hn::And(hn::Gt(sum, Set(1e-6F) * whole), hn::Gt(sum, Set(0.0F))));
    a[Entry(i, i)] = Set(1.0F) / hn::Sqrt(sum);
  }
  return good;
}

HWY_INLINE std::array<V, 4> Substitute(const std::array<V, 10>& a, std::array<V, 4> b) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] = b[i] - a[Entry(i, k)] * b[k];
    b[i] = b[i] * a[Entry(i, i)];
  }
  for (std::size_t i = 4; i-- > 0;) {
    for (std::size_t k = i + 1; k < 4; ++k) b[i] = b[i] - a[Entry(k, i)] * b[k];
    b[i] = b[i] * a[Entry(i, i)];
  }
  return b;
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // DORSUM_STRIPES_LANE_EQUATIONS_INL_H_
