// SPDX-License-Identifier: Apache-2.0
// Included once for each instruction set (Highway), by plate_solver.cc.
#if defined(DORSUM_SURFACE_PLATE_CYCLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DORSUM_SURFACE_PLATE_CYCLE_INL_H_
#undef DORSUM_SURFACE_PLATE_CYCLE_INL_H_
#else
#define DORSUM_SURFACE_PLATE_CYCLE_INL_H_
#endif

#include <hwy/highway.h>

#include "surface/plate_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

// One cycle over the grids, from the finest to the coarsest and back: an approximate solution of
// matrix * x = right that is linear and symmetric in the right side. Heights run straight between the nodes
// of the next coarser grid; residuals go back by the transpose of that.
class Cycle {
 public:
  Cycle(std::span<const PlateSystem> systems, std::vector<PlateSolver::Grid>* grids)
      : systems_(systems), grids_(*grids) {
    for (const PlateSystem& s : systems) matrices_.emplace_back(s);
  }

  // Of grids[k].right.
  const float* Run(std::size_t k = 0) {
    const Matrix& m = matrices_[k];
    PlateSolver::Grid* g = &grids_[k];
    if (k + 1 == grids_.size()) {
      Smooth(m, kBottom, true, g);
      Smooth(m, kBottom, false, g);
      return g->x.data();
    }
    Smooth(m, kSmooth, true, g);
    const float *x = g->x.data(), *right = g->right.data();
    float* residual = g->residual.data();
    const D d;
    m.ForAll(
        [&](std::size_t i) { hn::StoreU(hn::Sub(hn::LoadU(d, right + i), m.Times(x, i)), d, residual + i); });
    Restrict(k);
    Run(k + 1);
    Prolong(k);
    Smooth(m, kSmooth, false, g);
    return g->x.data();
  }

 private:
  // x' = x + step / diagonal * (right - matrix * x) + on * (x - the x before).
  struct Step {
    float step, on;
  };
  // Chebyshev's polynomial that is smallest between kHighest / ratio and kHighest. No eigenvalue of a plate's
  // matrix over its diagonal is above 4, since none of its terms holds more than four nodes.
  template <std::size_t N>
  static std::array<Step, N> Chebyshev(double ratio) {
    constexpr double kHighest = 4.0;
    const double middle = 0.5 * kHighest * (1.0 + 1.0 / ratio), half = 0.5 * kHighest * (1.0 - 1.0 / ratio);
    std::array<Step, N> out;
    double rho = half / middle;
    out[0] = {static_cast<float>(1.0 / middle), 0.0F};
    for (std::size_t k = 1; k < N; ++k) {
      const double next = 1.0 / (2.0 * middle / half - rho);
      out[k] = {static_cast<float>(2.0 * next / half), static_cast<float>(next * rho)};
      rho = next;
    }
    return out;
  }

  // Takes out of x what changes quickly from node to node.
  static void Smooth(const Matrix& m, std::span<const Step> steps, bool from_zero, PlateSolver::Grid* g) {
    const D d;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const V step = hn::Set(d, steps[k].step), on = hn::Set(d, steps[k].on);
      const float *right = g->right.data(), *x = g->x.data();
      float* other = g->other.data();
      if (from_zero && k == 0) {
        m.ForAll([&](std::size_t i) {
          hn::StoreU(hn::Mul(hn::Mul(step, m.Inverse(i)), hn::LoadU(d, right + i)), d, other + i);
        });
      } else {
        const bool second = from_zero && k == 1;  // the x before was zero
        m.ForAll([&](std::size_t i) {
          const V here = hn::LoadU(d, x + i);
          const V residual = hn::Sub(hn::LoadU(d, right + i), m.Times(x, i));
          const V moved = MulThenAdd(hn::Mul(step, m.Inverse(i)), residual, here);
          const V before = second || k == 0 ? hn::Zero(d) : hn::LoadU(d, other + i);
          hn::StoreU(MulThenAdd(on, hn::Sub(here, before), moved), d, other + i);
        });
      }
      std::swap(g->x, g->other);
    }
  }

  // Grid k's residual becomes the right side of the next one. Coarse column c of the storage lies at fine
  // column 2 c - 2, since both have the same frame.
  void Restrict(std::size_t k) {
    const D d;
    const V half = hn::Set(d, 0.5F);
    const std::size_t fine_wide = systems_[k].columns(), wide = systems_[k + 1].columns();
    const std::vector<PlateSystem::Range>& spans = systems_[k + 1].spans();
    for (std::size_t r = 0; r < spans.size(); ++r) {
      const float* in = grids_[k].residual.data() + (2 * r + PlateSystem::kFrame) * fine_wide;
      float* out = grids_[k + 1].right.data() + (r + PlateSystem::kFrame) * wide;
      const auto column = [&](const float* p) {
        return MulThenAdd(half, hn::Add(hn::LoadU(d, p - fine_wide), hn::LoadU(d, p + fine_wide)),
                          hn::LoadU(d, p));
      };
      for (std::size_t c = spans[r].first; c < spans[r].second; c += kLanes) {
        HWY_ALIGN std::array<float, 3 * PlateSystem::kBlock> t;
        const float* p = in + 2 * c - 3;
        for (std::size_t j = 0; j < 3; ++j) hn::StoreU(column(p + j * kLanes), d, &t[j * kLanes]);
        V west, here, east, unused;
        hn::LoadInterleaved2(d, t.data(), west, here);
        hn::LoadInterleaved2(d, t.data() + 2, east, unused);
        hn::StoreU(MulThenAdd(half, hn::Add(west, east), here), d, out + c);
      }
    }
  }

  // Adds the next grid's x to that of grid k.
  void Prolong(std::size_t k) {
    const D d;
    const V half = hn::Set(d, 0.5F);
    const std::size_t wide = systems_[k].columns(), coarse_wide = systems_[k + 1].columns();
    const std::vector<PlateSystem::Range>& spans = systems_[k].spans();
    for (std::size_t r = 0; r < spans.size(); ++r) {
      const float* north = grids_[k + 1].x.data() + (r / 2 + PlateSystem::kFrame) * coarse_wide;
      const float* south = grids_[k + 1].x.data() + ((r + 1) / 2 + PlateSystem::kFrame) * coarse_wide;
      float* out = grids_[k].x.data() + (r + PlateSystem::kFrame) * wide;
      const auto between = [&](std::size_t c) {
        return hn::Mul(half, hn::Add(hn::LoadU(d, north + c), hn::LoadU(d, south + c)));
      };
      for (std::size_t i = spans[r].first; i < spans[r].second; i += 2 * kLanes) {
        const V here = between(i / 2 + 1), east = between(i / 2 + 2);
        HWY_ALIGN std::array<float, 2 * PlateSystem::kBlock> t;
        hn::StoreInterleaved2(here, hn::Mul(half, hn::Add(here, east)), d, t.data());
        const std::size_t end = std::min(spans[r].second, i + 2 * kLanes);
        for (std::size_t j = i; j < end; j += kLanes) {
          hn::StoreU(hn::Add(hn::Load(d, &t[j - i]), hn::LoadU(d, out + j)), d, out + j);
        }
      }
    }
  }

  // Found by trying: two steps on each way, and on the coarsest grid as many as make it exact enough.
  inline static const std::array<Step, 2> kSmooth = Chebyshev<2>(6.0);
  inline static const std::array<Step, 12> kBottom = Chebyshev<12>(60.0);

  std::span<const PlateSystem> systems_;
  std::vector<PlateSolver::Grid>& grids_;
  std::vector<Matrix> matrices_;
};

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // DORSUM_SURFACE_PLATE_CYCLE_INL_H_
