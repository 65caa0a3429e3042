// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "base/simd.h"
#include "surface/plate_system.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/plate_gradients.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Sums over whole blocks, each of a block's places on its own, so that the result does not depend on how
// many numbers a machine takes at a time.
class BlockSum {
 public:
  using D = hn::CappedTag<float, PlateSystem::kBlock>;
  using V = hn::Vec<D>;
  static constexpr std::size_t kLanes = hn::MaxLanes(D());
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
template <class V>
HWY_INLINE V MulThenAdd(V a, V b, V sum) {
  return hn::Add(hn::Mul(a, b), sum);
}

class Gradients {
 public:
  explicit Gradients(const PlateSystem& system) : s_(system), offsets_(system.Offsets()) {}

  int Solve(int max_iterations, double tolerance, std::vector<float>* x) {
    residual_.assign(s_.size(), 0.0F);
    direction_.assign(s_.size(), 0.0F);
    image_.assign(s_.size(), 0.0F);
    double rho = Begin(x->data());
    const double enough = rho * tolerance * tolerance;
    int iteration = 0;
    for (; iteration < max_iterations && rho > enough && rho > 0.0; ++iteration) {
      const double curvature = Multiply(direction_.data());
      if (!(curvature > 0.0)) break;
      const double next = Advance(static_cast<float>(rho / curvature), x->data());
      Turn(static_cast<float>(next / rho));
      rho = next;
    }
    return iteration;
  }

 private:
  using D = BlockSum::D;
  using V = BlockSum::V;

  // Calls body(first node, place among its block's vectors) for every vector of every run, and sums what it
  // returns.
  template <class Body>
  double ForAll(const Body& body) const {
    double total = 0.0;
    for (const auto& [begin, end] : s_.runs()) {
      BlockSum sum;
      for (std::size_t i = begin; i < end; i += PlateSystem::kBlock) {
        for (std::size_t k = 0; k < BlockSum::kVectors; ++k) sum.Add(k, body(i + k * BlockSum::kLanes));
      }
      total += sum.Total();
    }
    return total;
  }

  // image = matrix * in; returns the product of both.
  double Multiply(const float* in) {
    const D d;
    float* out = image_.data();
    const float* diagonal = s_.diagonal.data();
    return ForAll([&](std::size_t i) {
      const V here = hn::LoadU(d, in + i);
      V y = hn::Mul(hn::LoadU(d, diagonal + i), here);
      for (std::size_t k = 0; k < offsets_.size(); ++k) {
        const float* a = s_.upper[k].data();
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i), o = offsets_[k];
        y = MulThenAdd(hn::LoadU(d, a + at), hn::LoadU(d, in + at + o), y);
        y = MulThenAdd(hn::LoadU(d, a + at - o), hn::LoadU(d, in + at - o), y);
      }
      hn::StoreU(y, d, out + i);
      return hn::Mul(here, y);
    });
  }

  double Begin(const float* x) {
    const D d;
    Multiply(x);
    return ForAll([&](std::size_t i) {
      const V r = hn::Sub(hn::LoadU(d, &s_.right[i]), hn::LoadU(d, &image_[i]));
      const V scaled = hn::Mul(hn::LoadU(d, &s_.inverse[i]), r);
      hn::StoreU(r, d, &residual_[i]);
      hn::StoreU(scaled, d, &direction_[i]);
      return hn::Mul(r, scaled);
    });
  }

  // A step along the direction; returns the new residual's size.
  double Advance(float alpha, float* x) {
    const D d;
    const V step = hn::Set(d, alpha), back = hn::Set(d, -alpha);
    return ForAll([&](std::size_t i) {
      hn::StoreU(MulThenAdd(step, hn::LoadU(d, &direction_[i]), hn::LoadU(d, x + i)), d, x + i);
      const V r = MulThenAdd(back, hn::LoadU(d, &image_[i]), hn::LoadU(d, &residual_[i]));
      hn::StoreU(r, d, &residual_[i]);
      return hn::Mul(r, hn::Mul(hn::LoadU(d, &s_.inverse[i]), r));
    });
  }

  void Turn(float beta) {
    const D d;
    const V share = hn::Set(d, beta);
    ForAll([&](std::size_t i) {
      const V scaled = hn::Mul(hn::LoadU(d, &s_.inverse[i]), hn::LoadU(d, &residual_[i]));
      hn::StoreU(MulThenAdd(share, hn::LoadU(d, &direction_[i]), scaled), d, &direction_[i]);
      return hn::Zero(d);
    });
  }

  const PlateSystem& s_;
  const std::array<std::ptrdiff_t, 6> offsets_;
  std::vector<float> residual_, direction_, image_;
};

int Solve(const PlateSystem& system, int max_iterations, double tolerance, std::vector<float>* x) {
  return Gradients(system).Solve(max_iterations, tolerance, x);
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(Solve);

int SolveByGradients(const PlateSystem& system, int max_iterations, double tolerance, std::vector<float>* x) {
  return HWY_DYNAMIC_DISPATCH(Solve)(system, max_iterations, tolerance, x);
}

}  // namespace dorsum
#endif
