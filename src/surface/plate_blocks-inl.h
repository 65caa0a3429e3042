// SPDX-License-Identifier: Apache-2.0
// Included once for each instruction set (Highway), by plate_solver.cc.
#if defined(DORSUM_SURFACE_PLATE_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DORSUM_SURFACE_PLATE_BLOCKS_INL_H_
#undef DORSUM_SURFACE_PLATE_BLOCKS_INL_H_
#else
#define DORSUM_SURFACE_PLATE_BLOCKS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, PlateSystem::kBlock>;
using V = hn::Vec<D>;
constexpr std::size_t kLanes = hn::MaxLanes(D());

// Sums over whole blocks, each of a block's places on its own, so that the result does not depend on how
// many numbers a machine takes at a time.
class BlockSum {
 public:
  static constexpr std::size_t kVectors = PlateSystem::kBlock / kLanes;

  BlockSum() { sums_.fill(hn::Zero(D())); }
  void Add(std::size_t vector, V value) { sums_[vector] = hn::Add(sums_[vector], value); }
  double Total() const {
    std::array<float, PlateSystem::kBlock> all;
    for (std::size_t k = 0; k < kVectors; ++k) hn::StoreU(sums_[k], D(), &all[k * kLanes]);
    double total = 0.0;
    for (const float one : all) total += static_cast<double>(one);
    return total;
  }

 private:
  std::array<V, kVectors> sums_;
};

// Without fused products, which not every machine has.
HWY_INLINE V MulThenAdd(V a, V b, V sum) { return hn::Add(hn::Mul(a, b), sum); }

// The matrix of a system, as it is applied to vectors of nodes.
class Matrix {
 public:
  explicit Matrix(const PlateSystem& system) : s_(&system), offsets_(system.Offsets()) {
    for (std::size_t k = 0; k < offsets_.size(); ++k) upper_[k] = system.upper[k].data();
    diagonal_ = system.diagonal.data();
    inverse_ = system.inverse.data();
  }

  // Rows i and on of matrix * in.
  HWY_INLINE V Times(const float* HWY_RESTRICT in, std::size_t i) const {
    const D d;
    const auto at = static_cast<std::ptrdiff_t>(i);
    V later = hn::Mul(hn::LoadU(d, diagonal_ + i), hn::LoadU(d, in + i)), earlier = hn::Zero(d);
    for (std::size_t k = 0; k < 6; ++k) {
      const std::ptrdiff_t o = offsets_[k];
      later = MulThenAdd(hn::LoadU(d, upper_[k] + at), hn::LoadU(d, in + at + o), later);
      earlier = MulThenAdd(hn::LoadU(d, upper_[k] + at - o), hn::LoadU(d, in + at - o), earlier);
    }
    return hn::Add(later, earlier);
  }
  HWY_INLINE V Inverse(std::size_t i) const { return hn::LoadU(D(), inverse_ + i); }

  // Calls body(first node) for every vector of every run.
  template <class Body>
  HWY_INLINE void ForAll(const Body& body) const {
    for (const auto& [begin, end] : s_->runs()) {
      for (std::size_t i = begin; i < end; i += kLanes) body(i);
    }
  }

  // The same, and sums what it returns.
  template <class Body>
  HWY_INLINE double SumAll(const Body& body) const {
    double total = 0.0;
    for (const auto& [begin, end] : s_->runs()) {
      BlockSum sum;
      for (std::size_t i = begin; i < end; i += PlateSystem::kBlock) {
        for (std::size_t k = 0; k < BlockSum::kVectors; ++k) sum.Add(k, body(i + k * kLanes));
      }
      total += sum.Total();
    }
    return total;
  }

 private:
  const PlateSystem* s_;
  std::array<std::ptrdiff_t, 6> offsets_;
  std::array<const float*, 6> upper_;
  const float *diagonal_, *inverse_;
};

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // DORSUM_SURFACE_PLATE_BLOCKS_INL_H_
