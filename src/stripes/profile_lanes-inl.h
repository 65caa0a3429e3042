// SPDX-License-Identifier: Apache-2.0
// Included once for each instruction set (Highway), by profile_batch.cc.
#if defined(DORSUM_STRIPES_PROFILE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DORSUM_STRIPES_PROFILE_LANES_INL_H_
#undef DORSUM_STRIPES_PROFILE_LANES_INL_H_
#else
#define DORSUM_STRIPES_PROFILE_LANES_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "stripes/lane_equations-inl.h"
#include "stripes/profile_fit.h"

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

enum class FitState : std::uint8_t { kIdle, kRunning, kFound, kFailed };

// Levenberg-Marquardt for one profile in every lane (profile_fit.h). Columns are counted from each lane's own
// middle, near its start.
class Lanes {
 public:
  static constexpr std::size_t kLanes = hn::MaxLanes(D());

  Lanes(const NoiseModel& noise, const ProfileFitOptions& options) : options_(options), noise_(noise) {}

  FitState State(std::size_t lane) const { return state_[lane]; }

  // Nothing is left to do in this lane.
  void Clear(std::size_t lane) {
    state_[lane] = FitState::kIdle;
    low_[lane] = 1.0F;
    high_[lane] = 0.0F;
    reach_[lane] = 0;
    for (auto* a : {&u_, &amplitude_, &background_, &next_u_, &next_amplitude_, &next_background_})
      (*a)[lane] = 0.0F;
    width_[lane] = next_width_[lane] = 1.0F;
  }

  void Load(std::size_t lane, const std::uint8_t* row, const ProfileStart& start, const ProfileFit& fit) {
    const int middle = std::clamp(static_cast<int>(std::lround(fit.u)), fit.first, fit.last);
    middle_[lane] = middle;
    state_[lane] = FitState::kRunning;
    rounds_[lane] = 0;
    low_[lane] = static_cast<float>(fit.first - middle);
    high_[lane] = static_cast<float>(fit.last - middle);
    reach_[lane] = std::max(middle - fit.first, fit.last - middle);
    for (int x = fit.first; x <= fit.last; ++x) {
      const auto column = static_cast<std::size_t>(kMiddle + x - middle);
      grey_[column][lane] = static_cast<float>(row[x]);
      gain_[column][lane] = start.GainAt(x);
    }
    for (auto* u : {&u_, &next_u_}) (*u)[lane] = static_cast<float>(fit.u - middle);
    for (auto* w : {&width_, &next_width_}) (*w)[lane] = static_cast<float>(fit.width);
    for (auto* a : {&amplitude_, &next_amplitude_}) (*a)[lane] = static_cast<float>(fit.amplitude);
    for (auto* b : {&background_, &next_background_}) (*b)[lane] = static_cast<float>(fit.background);
    start_u_[lane] = static_cast<float>(start.u - middle);
    start_width_[lane] = static_cast<float>(start.width);
    beyond_[lane] = start.hold_width ? static_cast<float>(start.width) : 0.0F;
    held_[lane] = fit.width_held ? 1.0F : 0.0F;
    prior_[lane] = static_cast<float>(start.amplitude);
    prior_weight_[lane] =
        start.amplitude_sd > 0.0 ? static_cast<float>(1.0 / (start.amplitude_sd * start.amplitude_sd)) : 0.0F;
    cost_[lane] = 1e30F;
    damping_[lane] = 1e-3F;
    trial_[lane] = 1.0F;
    small_[lane] = 0.0F;
  }

  // What the lane found.
  void Store(std::size_t lane, ProfileFit* fit) const {
    fit->u = middle_[lane] + static_cast<double>(u_[lane]);
    fit->width = static_cast<double>(width_[lane]);
    fit->amplitude = static_cast<double>(amplitude_[lane]);
    fit->background = static_cast<double>(background_[lane]);
    const auto variance = static_cast<double>(variance_[lane]);
    fit->sd_u = std::sqrt(variance);
    fit->ok = state_[lane] == FitState::kFound && variance > 0.0 && std::isfinite(variance);
  }

  // One step of every lane that runs: weighs the trial, and prepares the next.
  void Step();

 private:
  static constexpr int kMiddle = kMostHalfWindow + 1;
  using Floats = std::array<float, kLanes>;

  static HWY_INLINE V Get(const Floats& from) { return hn::LoadU(D(), from.data()); }
  static HWY_INLINE void Put(V value, Floats* to) { hn::StoreU(value, D(), to->data()); }

  Equations Linearise() const;
  V Variance(V grey) const {
    const V g = hn::Clamp(grey, Set(0.0F), Set(255.0F));
    return Set(static_cast<float>(noise_.constant)) +
           g * (Set(static_cast<float>(noise_.linear)) + g * Set(static_cast<float>(noise_.quadratic)));
  }

  const ProfileFitOptions& options_;
  const NoiseModel& noise_;
  std::array<FitState, kLanes> state_{};
  std::array<int, kLanes> middle_{}, reach_{}, rounds_{};
  Floats low_{}, high_{};                              // columns of the window
  Floats u_{}, width_{}, amplitude_{}, background_{};  // where the lane stands
  Floats next_u_{}, next_width_{}, next_amplitude_{}, next_background_{};
  Floats start_u_{}, start_width_{}, beyond_{}, held_{}, prior_{}, prior_weight_{};
  Floats cost_{}, damping_{}, variance_{};
  Floats trial_{};  // 1 if the next place is worth a look, 0 if it is out of bounds
  Floats small_{};  // 1 if the step to it is so small that it is the last
  std::array<Floats, 10> matrix_{};
  std::array<Floats, 4> right_{};
  std::array<Floats, 2 * kMiddle + 1> grey_, gain_;
};

inline Equations Lanes::Linearise() const {
  const V u = Get(next_u_), amplitude = Get(next_amplitude_), background = Get(next_background_);
  const V inverse = Set(1.0F) / Get(next_width_);
  const V low = Get(low_), high = Get(high_), saturated = Set(static_cast<float>(options_.saturated_grey));
  Sums sums;
  const auto add = [&](int column, V shape) {
    const V at = Set(static_cast<float>(column));
    const V t = (at - u) * inverse;
    M seen = hn::And(hn::Ge(at, low), hn::Le(at, high));
    const auto k = static_cast<std::size_t>(kMiddle + column);
    const V gain = hn::IfThenElseZero(seen, Get(gain_[k])), grey = hn::IfThenElseZero(seen, Get(grey_[k]));
    seen = hn::And(seen, hn::Gt(gain, Set(0.0F)));
    shape = gain * shape;
    const V signal = amplitude * shape, model = gain * background + signal;
    // Clipped pixels only speak where the model stays below them.
    const M clipped = hn::Ge(grey, saturated);
    const V residual = hn::IfThenElse(clipped, saturated, grey) - model;
    seen = hn::AndNot(hn::And(clipped, hn::Le(residual, Set(0.0F))), seen);
    const V slope = signal * t * inverse;
    sums.Add({slope, slope * t, shape, gain}, residual, Variance(model), seen);
  };
  // exp(-t^2 / 2) column by column from the middle outwards: the quotient of two neighbours changes by a
  // constant factor.
  const int reach = *std::max_element(reach_.begin(), reach_.end());
  const V t = (Set(0.0F) - u) * inverse;
  const V peak = Exp(Set(-0.5F) * t * t), root = Exp(Set(-0.5F) * inverse * inverse), bend = root * root;
  const V slope = Exp(Set(0.0F) - t * inverse);
  add(0, peak);
  V up = peak, up_step = slope * root, down = peak, down_step = root / slope;
  for (int k = 1; k <= reach; ++k) {
    up = up * up_step;
    up_step = up_step * bend;
    down = down * down_step;
    down_step = down_step * bend;
    add(k, up);
    add(-k, down);
  }
  sums.Close();
  Equations& e = sums.equations();
  const V weight = Get(prior_weight_), residual = Get(prior_) - amplitude;
  e.matrix[Entry(2, 2)] = e.matrix[Entry(2, 2)] + weight;
  e.right[2] = e.right[2] + weight * residual;
  e.cost = e.cost + weight * residual * residual;
  return e;
}

inline void Lanes::Step() {
  // Weighs the trial.
  const Equations there = Linearise();
  const V nothing = Set(0.0F), one = Set(1.0F);
  const M tried = hn::Gt(Get(trial_), nothing);
  const M better = hn::And(tried, hn::Le(there.cost, Get(cost_) + Set(1e-4F)));
  const M first = hn::Ge(Get(cost_), Set(1e29F));
  const V width = hn::IfThenElse(better, Get(next_width_), Get(width_));
  const V u = hn::IfThenElse(better, Get(next_u_), Get(u_));
  const V amplitude = hn::IfThenElse(better, Get(next_amplitude_), Get(amplitude_));
  const V background = hn::IfThenElse(better, Get(next_background_), Get(background_));
  std::array<V, 10> matrix;
  std::array<V, 4> right;
  for (std::size_t i = 0; i < 10; ++i) matrix[i] = hn::IfThenElse(better, there.matrix[i], Get(matrix_[i]));
  for (std::size_t i = 0; i < 4; ++i) right[i] = hn::IfThenElse(better, there.right[i], Get(right_[i]));
  for (std::size_t i = 0; i < 10; ++i) Put(matrix[i], &matrix_[i]);
  for (std::size_t i = 0; i < 4; ++i) Put(right[i], &right_[i]);
  Put(hn::IfThenElse(better, there.cost, Get(cost_)), &cost_);
  const V old = Get(damping_);
  V damping = hn::IfThenElse(tried, old * Set(10.0F), old * Set(10.0F) + Set(1e-2F));
  damping = hn::IfThenElse(first, old, hn::IfThenElse(better, old * Set(0.1F), damping));
  Put(damping, &damping_);
  const M settled = hn::AndNot(first, hn::And(better, hn::Gt(Get(small_), nothing)));
  // Beyond all damping there is no better place; if there was none within bounds, there is none at all.
  const M stuck = hn::Gt(damping, Set(1e6F));

  // The next trial.
  const M held = hn::Gt(Get(held_), nothing);
  for (const std::size_t entry : {Entry(1, 0), Entry(2, 1), Entry(3, 1)})
    matrix[entry] = hn::IfThenElse(held, nothing, matrix[entry]);
  matrix[Entry(1, 1)] = hn::IfThenElse(held, one, matrix[Entry(1, 1)]);
  right[1] = hn::IfThenElse(held, nothing, right[1]);
  std::array<V, 10> factor = matrix;
  const M whole = Factorise(&factor);
  const V column = Substitute(factor, {one, nothing, nothing, nothing})[0];
  Put(hn::IfThenElseZero(whole, column), &variance_);
  for (std::size_t i = 0; i < 4; ++i) matrix[Entry(i, i)] = matrix[Entry(i, i)] * (one + damping);
  const M solvable = hn::AndNot(hn::AndNot(better, first), Factorise(&matrix));
  const std::array<V, 4> step = Substitute(matrix, right);
  const V reach = Set(0.7F) * width;
  const V next_u = u + hn::Clamp(step[0], nothing - reach, reach);
  const V next_width = hn::Clamp(width + step[1], Set(0.6F) * width, Set(1.7F) * width);
  const V next_amplitude = amplitude + step[2], next_background = background + step[3];
  Put(next_u, &next_u_);
  Put(next_width, &next_width_);
  Put(next_amplitude, &next_amplitude_);
  Put(next_background, &next_background_);
  const V beyond = Get(beyond_), moved = hn::Abs(next_u - Get(start_u_));
  M sane = hn::And(hn::Gt(next_u, Get(low_) - beyond), hn::Lt(next_u, Get(high_) + beyond));
  sane = hn::And(sane, hn::Lt(moved, Set(1.5F) * hn::Max(next_width, Get(start_width_))));
  sane = hn::And(sane, hn::And(hn::Gt(next_amplitude, nothing), hn::Lt(next_amplitude, Set(5000.0F))));
  sane = hn::And(sane, hn::And(hn::Ge(next_width, Set(static_cast<float>(options_.min_width_px))),
                               hn::Le(next_width, Set(static_cast<float>(options_.max_width_px)))));
  Put(hn::IfThenElseZero(sane, one), &trial_);
  // Steps shrink at least tenfold here, so what is left of the centre is far below its noise.
  const M small =
      hn::And(hn::And(hn::Lt(hn::Abs(step[0]), Set(3e-2F)), hn::Lt(hn::Abs(step[1]), Set(5e-2F) * width)),
              hn::Lt(hn::Abs(step[2]), Set(1e-2F) * amplitude + Set(0.05F)));
  Put(hn::IfThenElseZero(small, one), &small_);
  // A step so small from a place that was weighed needs no weighing of its own.
  const M last = hn::And(hn::And(better, small), sane);
  Put(hn::IfThenElse(last, next_u, u), &u_);
  Put(hn::IfThenElse(last, next_width, width), &width_);
  Put(hn::IfThenElse(last, next_amplitude, amplitude), &amplitude_);
  Put(hn::IfThenElse(last, next_background, background), &background_);

  Floats is_settled, is_stuck, was_tried, is_solvable;
  Put(hn::IfThenElseZero(hn::Or(settled, last), one), &is_settled);
  Put(hn::IfThenElseZero(stuck, one), &is_stuck);
  Put(hn::IfThenElseZero(tried, one), &was_tried);
  Put(hn::IfThenElseZero(solvable, one), &is_solvable);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (state_[lane] != FitState::kRunning) continue;
    if (is_settled[lane] > 0.0F || rounds_[lane]++ >= options_.max_iterations) {
      state_[lane] = FitState::kFound;
    } else if (is_stuck[lane] > 0.0F) {
      state_[lane] = was_tried[lane] > 0.0F ? FitState::kFound : FitState::kFailed;
    } else if (is_solvable[lane] == 0.0F) {
      state_[lane] = FitState::kFailed;
    }
  }
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // DORSUM_STRIPES_PROFILE_LANES_INL_H_
