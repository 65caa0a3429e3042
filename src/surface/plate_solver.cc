// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_solver.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/plate_solver.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "surface/plate_blocks-inl.h"
#include "surface/plate_cycle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

class Gradients {
 public:
  Gradients(std::span<const PlateSystem> systems, std::vector<PlateSolver::Grid>* grids, float* direction,
            float* image)
      : matrix_(systems[0]),
        cycle_(systems, grids),
        residual_((*grids)[0].right.data()),
        direction_(direction),
        image_(image) {}

  int Solve(const float* right, int max_iterations, double tolerance, float* x) {
    double rho = Begin(right);
    const double enough = rho * tolerance * tolerance;
    int iteration = 0;
    for (; iteration < max_iterations && rho > enough && rho > 0.0; ++iteration) {
      const double curvature = Multiply();
      if (!(curvature > 0.0)) break;
      Advance(static_cast<float>(rho / curvature), x);
      if (iteration + 1 == max_iterations) return max_iterations;
      rho = Turn(rho);
    }
    return iteration;
  }

 private:
  double Begin(const float* right) {
    const D d;
    matrix_.ForAll([&](std::size_t i) { hn::StoreU(hn::LoadU(d, right + i), d, residual_ + i); });
    const float* z = cycle_.Run();
    return matrix_.SumAll([&](std::size_t i) {
      const V scaled = hn::LoadU(d, z + i);
      hn::StoreU(scaled, d, direction_ + i);
      return hn::Mul(hn::LoadU(d, residual_ + i), scaled);
    });
  }

  // image = matrix * direction; returns the product of both.
  double Multiply() {
    const D d;
    return matrix_.SumAll([&](std::size_t i) {
      const V y = matrix_.Times(direction_, i);
      hn::StoreU(y, d, image_ + i);
      return hn::Mul(hn::LoadU(d, direction_ + i), y);
    });
  }

  void Advance(float alpha, float* x) {
    const D d;
    const V step = hn::Set(d, alpha), back = hn::Set(d, -alpha);
    matrix_.ForAll([&](std::size_t i) {
      hn::StoreU(MulThenAdd(step, hn::LoadU(d, direction_ + i), hn::LoadU(d, x + i)), d, x + i);
      hn::StoreU(MulThenAdd(back, hn::LoadU(d, image_ + i), hn::LoadU(d, residual_ + i)), d, residual_ + i);
    });
  }

  double Turn(double rho) {
    const D d;
    const float* z = cycle_.Run();
    const double next = matrix_.SumAll(
        [&](std::size_t i) { return hn::Mul(hn::LoadU(d, z + i), hn::LoadU(d, residual_ + i)); });
    const V share = hn::Set(d, static_cast<float>(next / rho));
    matrix_.ForAll([&](std::size_t i) {
      hn::StoreU(MulThenAdd(share, hn::LoadU(d, direction_ + i), hn::LoadU(d, z + i)), d, direction_ + i);
    });
    return next;
  }

  Matrix matrix_;
  Cycle cycle_;
  float *residual_, *direction_, *image_;
};

int Solve(std::span<const PlateSystem> systems, std::vector<PlateSolver::Grid>* grids, const float* right,
          int max_iterations, double tolerance, float* direction, float* image, float* x) {
  return Gradients(systems, grids, direction, image).Solve(right, max_iterations, tolerance, x);
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(Solve);

int PlateSolver::Solve(std::span<const PlateSystem> systems, const std::vector<float>& right,
                       int max_iterations, double tolerance, std::vector<float>* x) {
  grids_.resize(systems.size());
  for (std::size_t k = 0; k < systems.size(); ++k) {
    const std::size_t size = systems[k].size();
    for (auto* buffer : {&grids_[k].x, &grids_[k].other, &grids_[k].right}) {
      if (buffer->size() != size) buffer->assign(size, 0.0F);
    }
    grids_[k].residual.assign(size, 0.0F);  // no other lattice's values beside this one's nodes
  }
  for (auto* buffer : {&direction_, &image_}) {
    if (buffer->size() != x->size()) buffer->assign(x->size(), 0.0F);
  }
  return HWY_DYNAMIC_DISPATCH(dorsum::Solve)(systems, &grids_, right.data(), max_iterations, tolerance,
                                             direction_.data(), image_.data(), x->data());
}

}  // namespace dorsum
#endif
