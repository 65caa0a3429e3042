// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_problem.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>

#include "calibration/bundle_equations.h"
#include "calibration/stripe_model.h"

namespace dorsum {
namespace {

// All parameters of a state, as BundleLayout lists them.
std::vector<double*> Parameters(const BundleLayout& layout, BundleState* state) {
  std::vector<double*> all;
  const auto add = [&all](auto& values) {
    for (double& value : values) all.push_back(&value);
  };
  add(state->lens.value);
  add(state->camera_from_world.value);
  for (FanParameters& fan : state->fans) add(fan.value);
  for (auto& plane : state->planes) add(plane);
  add(state->board_bow);
  for (int i = 0; i < layout.boards; ++i) add(state->world_from_board[static_cast<std::size_t>(i)].value);
  return all;
}

void KeepInBounds(BundleState* state) {
  for (FanParameters& fan : state->fans) {
    fan.value[kFanDistance] = std::clamp(fan.value[kFanDistance], 0.0, 200.0);
    fan.value[kFanStep] = std::max(fan.value[kFanStep], 1e-4);
  }
}

// The part of the normal equations that moves, with columns of equal length, which keeps digits. What
// nothing was seen of has an empty column; it stays where it is.
class ScaledEquations {
 public:
  ScaledEquations(const NormalEquations& all, const std::vector<int>& free) {
    gradient_ = all.gradient(free);
    normal_ = all.normal(free, free);
    scale_.resize(normal_.cols());
    for (Eigen::Index i = 0; i < normal_.cols(); ++i) {
      seen_.push_back(normal_(i, i) > 0.0);
      if (!seen_.back()) normal_(i, i) = 1.0;
      scale_[i] = 1.0 / std::sqrt(normal_(i, i));
    }
    normal_ = scale_.asDiagonal() * normal_ * scale_.asDiagonal();
    gradient_ = gradient_.cwiseProduct(scale_);
  }

  // The step of Levenberg and Marquardt, and by how much it lowers the cost of the linear problem.
  std::optional<Eigen::VectorXd> Step(double damping, double* gain) const {
    Eigen::MatrixXd damped = normal_;
    damped.diagonal().array() += damping;
    const Eigen::LLT<Eigen::MatrixXd> factors(damped);
    if (factors.info() != Eigen::Success) return std::nullopt;
    const Eigen::VectorXd step = factors.solve(-gradient_);
    if (!step.allFinite()) return std::nullopt;
    *gain = -0.5 * gradient_.dot(step) + 0.5 * damping * step.squaredNorm();
    return step.cwiseProduct(scale_);
  }

  Eigen::MatrixXd Inverse() const {
    return scale_.asDiagonal() *
           normal_.ldlt().solve(Eigen::MatrixXd::Identity(normal_.rows(), normal_.cols())) *
           scale_.asDiagonal();
  }
  bool Seen(std::size_t i) const { return seen_[i]; }

 private:
  Eigen::VectorXd gradient_, scale_;
  Eigen::MatrixXd normal_;
  std::vector<bool> seen_;
};

// The covariance of [lens, pose, fans], which are whole blocks, and the planes' heights.
void FindUncertainties(const BundleEquations& equations, const NormalEquations& at, BundleSolution* out) {
  const ScaledEquations scaled(at, equations.Free());
  const Eigen::MatrixXd inverse = scaled.Inverse();
  const double factor = std::max(1.0, out->variance_factor);
  const BundleLayout& layout = equations.Layout();
  const Eigen::Index size = layout.Plane(0);
  out->covariance.setZero(size, size);
  out->height_sd.assign(out->state.planes.size(), 0.0);
  const std::vector<int>& free = equations.Free();
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto r = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < free.size() && free[i] < size; ++k) {
      if (free[k] < size)
        out->covariance(free[i], free[k]) = factor * inverse(r, static_cast<Eigen::Index>(k));
    }
    for (int p = 0; p < layout.planes; ++p) {
      if (free[i] != layout.Plane(p) || !scaled.Seen(i)) continue;
      out->height_sd[static_cast<std::size_t>(p)] = std::sqrt(std::max(0.0, factor * inverse(r, r)));
    }
  }
}

// Levenberg and Marquardt, which begins as Gauss and Newton's method and goes back to it: the starts are
// good, and what the data hardly tell needs whole steps.
class BundleSolver {
 public:
  BundleSolver(const BundleData& data, const BundleProblemOptions& options, const Context& context,
               BundleState* state)
      : options_(options), context_(context), state_(*state), equations_(data, options, *state) {}

  Status Run() {
    constexpr double kEnough = 1e-9;  // of the cost, which leaves far less than a standard deviation
    constexpr double kLeastDamping = 1e-7, kMostDamping = 1e6;
    at_ = equations_.At(state_, context_);
    double damping = 0.0;
    for (int i = 0; i < options_.max_iterations && std::isfinite(at_.cost); ++i) {
      DORSUM_RETURN_IF_ERROR(context_.CheckCancelled());
      double gain = 0.0;
      const std::optional<BundleState> next = Move(damping, &gain);
      const bool small = gain <= kEnough * at_.cost && damping <= kLeastDamping;
      if (next && small) {
        // The equations there would be these ones.
        state_ = *next;
        at_.cost -= gain;
        return {};
      }
      NormalEquations there;
      if (next) there = equations_.At(*next, context_);
      if (!next || !(there.cost <= at_.cost)) {  // not finite is no better
        if (damping > kMostDamping || (next && gain <= kEnough * at_.cost)) return {};
        equations_.Forget();
        damping = std::max(kLeastDamping, 10.0 * damping);
        continue;
      }
      const double won = at_.cost - there.cost;
      state_ = *next;
      at_ = std::move(there);
      if (won <= kEnough * at_.cost && damping <= kLeastDamping) return {};
      damping = damping > kLeastDamping ? 0.1 * damping : 0.0;
    }
    DORSUM_RETURN_IF_ERROR(context_.CheckCancelled());
    if (std::isfinite(at_.cost)) return {};
    return BadInput("the stripes and chessboards do not determine the device; capture the series again");
  }

  const BundleEquations& Equations() const { return equations_; }
  const NormalEquations& There() const { return at_; }

 private:
  std::optional<BundleState> Move(double damping, double* gain) {
    std::vector<double*> now = Parameters(equations_.Layout(), &state_);
    // What stands at a bound and would go beyond stays.
    std::vector<int> free = equations_.Free();
    std::erase_if(free, [&](int i) {
      const int in_fan = (i - BundleLayout::Fan(0)) % kFanSize;
      if (i < BundleLayout::Fan(0) || i >= equations_.Layout().Plane(0)) return false;
      const double x = *now[static_cast<std::size_t>(i)];
      const bool down = at_.gradient[i] > 0.0;
      return (in_fan == kFanDistance && ((x <= 0.0 && down) || (x >= 200.0 && !down))) ||
             (in_fan == kFanStep && x <= 1e-4 && down);
    });
    const std::optional<Eigen::VectorXd> step = ScaledEquations(at_, free).Step(damping, gain);
    if (!step) return std::nullopt;
    BundleState next = state_;
    const std::vector<double*> then = Parameters(equations_.Layout(), &next);
    for (std::size_t i = 0; i < free.size(); ++i)
      *then[static_cast<std::size_t>(free[i])] += (*step)[static_cast<Eigen::Index>(i)];
    KeepInBounds(&next);
    return next;
  }

  const BundleProblemOptions& options_;
  const Context& context_;
  BundleState& state_;
  BundleEquations equations_;
  NormalEquations at_;
};

}  // namespace

Result<BundleSolution> SolveBundle(const BundleData& data, const BundleState& start,
                                   const BundleProblemOptions& options, const Context& context) {
  BundleSolution out;
  out.state = start;
  KeepInBounds(&out.state);
  BundleSolver solver(data, options, context, &out.state);
  DORSUM_RETURN_IF_ERROR(solver.Run());
  out.cost = solver.There().cost;
  const double freedom =
      std::max(1, solver.Equations().Residuals() - static_cast<int>(solver.Equations().Free().size()));
  out.variance_factor = 2.0 * out.cost / freedom;
  if (options.uncertainties) FindUncertainties(solver.Equations(), solver.There(), &out);
  return out;
}

double OrderMiss(const BundleState& state, const SheetPoint& p) {
  const StripeModel model(state.lens, state.camera_from_world, state.fans[static_cast<std::size_t>(p.laser)],
                          state.planes[static_cast<std::size_t>(p.plane)]);
  return model.Order({p.u, p.v}) - p.order;
}

}  // namespace dorsum
