// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_problem.h"

#include <algorithm>
#include <memory>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>
#include <ceres/normal_prior.h>

#include "calibration/bundle_functions.h"
#include "calibration/stripe_residual.h"

namespace dorsum {
namespace {

struct CornerResidual {
  Eigen::Vector3d on_board;
  Eigen::Vector2d share;  // place on the board, -1 to 1
  Eigen::Vector2d seen;
  Eigen::Matrix3d camera_start, board_start;
  double sd;

  template <class T>
  bool operator()(const T* lens, const T* camera, const T* board, const T* bow, T* residual) const {
    const double x = share.x(), y = share.y();
    const bundle::Vector3<T> p(T(on_board.x()), T(on_board.y()),
                               on_board.z() + bow[0] * (x * x) + bow[1] * (x * y) + bow[2] * (y * y));
    const bundle::Vector3<T> world = bundle::Transform<T>(board_start, board, p);
    const bundle::Vector3<T> in_camera = bundle::Transform<T>(camera_start, camera, world);
    const bundle::Vector2<T> pixel = bundle::ProjectPoint<T>(lens, in_camera);
    residual[0] = (pixel[0] - seen.x()) / sd;
    residual[1] = (pixel[1] - seen.y()) / sd;
    return true;
  }
};

// A board that lies on a plane: its centre's height and its slopes are the plane's.
struct LyingResidual {
  Eigen::Matrix3d board_start;
  double sd_mm, sd_rad;

  template <class T>
  bool operator()(const T* board, const T* plane, T* residual) const {
    bundle::Vector3<T> up(T(0.0), T(0.0), T(1.0)), turned;
    ceres::AngleAxisRotatePoint(board, up.data(), turned.data());
    const bundle::Vector3<T> normal = board_start.cast<T>() * turned;
    residual[0] = (board[5] - (plane[0] + plane[1] * board[3] + plane[2] * board[4])) / sd_mm;
    residual[1] = (normal[0] + plane[1]) / sd_rad;
    residual[2] = (normal[1] + plane[2]) / sd_rad;
    return true;
  }
};

class StopWhenCancelled : public ceres::IterationCallback {
 public:
  explicit StopWhenCancelled(const Context& context) : context_(context) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    (void)summary;
    return context_.IsCancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Context& context_;
};

// x ~ mean +- sd, one by one; an sd of 0 means no prior.
template <std::size_t N>
void AddPrior(ceres::Problem* problem, double* x, const std::array<double, N>& mean,
              const std::array<double, N>& sd) {
  ceres::Matrix a = ceres::Matrix::Zero(N, N);
  ceres::Vector b(N);
  for (std::size_t i = 0; i < N; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (sd[i] > 0.0) a(k, k) = 1.0 / sd[i];
    b[k] = mean[i];
  }
  problem->AddResidualBlock(new ceres::NormalPrior(a, b), nullptr, x);
}

class BundleBuilder {
 public:
  BundleBuilder(const BundleData& data, const BundleProblemOptions& options, BundleState* state)
      : data_(data), options_(options), s_(*state) {
    problem_.AddParameterBlock(s_.lens.value.data(), kLensSize);
    problem_.AddParameterBlock(s_.camera_from_world.value.data(), kPoseSize);
    for (auto& fan : s_.fans) problem_.AddParameterBlock(fan.value.data(), kFanSize);
    for (auto& plane : s_.planes) problem_.AddParameterBlock(plane.data(), kPlaneSize);
    AddPlanes();
    if (options.move_camera) {
      AddBoards();
    } else {
      problem_.SetParameterBlockConstant(s_.lens.value.data());
      problem_.SetParameterBlockConstant(s_.camera_from_world.value.data());
    }
    if (options.use_points) AddPoints();
  }

  ceres::Problem& problem() { return problem_; }

 private:
  void AddPlanes() {
    problem_.SetParameterBlockConstant(s_.planes[0].data());
    for (std::size_t i = 1; i < s_.planes.size(); ++i) {
      const double sd = data_.planes[i].sd_mm;
      if (sd <= 0.0) {
        problem_.SetParameterBlockConstant(s_.planes[i].data());
        continue;
      }
      // A plane of 200 mm that is off by sd at its ends.
      AddPrior<kPlaneSize>(&problem_, s_.planes[i].data(), {data_.planes[i].given_mm, 0.0, 0.0},
                           {options_.free_heights ? 0.0 : sd, 0.01 * sd, 0.01 * sd});
    }
  }

  void AddBoards() {
    Eigen::Vector2d half(1e-9, 1e-9);
    for (const auto& p : data_.board_points) half = half.cwiseMax(p.head<2>().cwiseAbs());
    problem_.AddParameterBlock(s_.board_bow.data(), kBoardBowSize);
    if (!options_.bow_boards) problem_.SetParameterBlockConstant(s_.board_bow.data());
    for (std::size_t i = 0; i < data_.boards.size(); ++i) {
      const BoardView& view = data_.boards[i];
      PoseParameters& pose = s_.world_from_board[i];
      for (std::size_t k = 0; k < view.corners.size(); ++k) {
        const Eigen::Vector3d& p = data_.board_points[k];
        auto* cost = new ceres::AutoDiffCostFunction<CornerResidual, 2, kLensSize, kPoseSize, kPoseSize,
                                                     kBoardBowSize>(
            new CornerResidual{p, p.head<2>().cwiseQuotient(half), view.corners[k],
                               s_.camera_from_world.start, pose.start, options_.corner_sd_px});
        problem_.AddResidualBlock(cost, new ceres::CauchyLoss(options_.loss_scale), s_.lens.value.data(),
                                  s_.camera_from_world.value.data(), pose.value.data(), s_.board_bow.data());
      }
      if (view.plane >= 0) {
        auto* cost = new ceres::AutoDiffCostFunction<LyingResidual, 3, kPoseSize, kPlaneSize>(
            new LyingResidual{pose.start, options_.lying_sd_mm, options_.lying_sd_rad});
        problem_.AddResidualBlock(cost, nullptr, pose.value.data(),
                                  s_.planes[static_cast<std::size_t>(view.plane)].data());
      }
      // The first board gives the world its origin and for the time being its x axis.
      if (i == 0) problem_.SetManifold(pose.value.data(), new ceres::SubsetManifold(kPoseSize, {2, 3, 4}));
    }
  }

  void AddPoints() {
    for (auto& fan : s_.fans) AddFanPrior(&fan);
    for (const SheetPoint& p : data_.points) {
      const double sd = std::hypot(p.sd_px, options_.point_sd_px) * p.orders_per_px;
      FanParameters& fan = s_.fans[static_cast<std::size_t>(p.laser)];
      auto* cost = new StripeResidual(s_.camera_from_world.start, fan.start, {p.u, p.v}, p.order, sd);
      problem_.AddResidualBlock(cost, new ceres::CauchyLoss(options_.loss_scale), s_.lens.value.data(),
                                s_.camera_from_world.value.data(),
                                s_.planes[static_cast<std::size_t>(p.plane)].data(), fan.value.data());
    }
  }

  void AddFanPrior(FanParameters* fan) {
    // mm, rad and cosines that a device can have; the data decide wherever they can.
    constexpr double kDistance = 15.0, kTurn = 0.1, kAlpha = 0.3, kSkew = 0.02, kBow = 0.15;
    AddPrior<kFanSize>(&problem_, fan->value.data(), {0, 0, 0, 0, 0, 0, kDistance, 0, 0, 0, 0},
                       {0, 0, 0, kTurn, kTurn, 0, kDistance, kAlpha, kSkew, kBow, 0});
    problem_.SetParameterLowerBound(fan->value.data(), kFanDistance, 0.0);
    problem_.SetParameterUpperBound(fan->value.data(), kFanDistance, 200.0);
    problem_.SetParameterLowerBound(fan->value.data(), kFanStep, 1e-4);
  }

  const BundleData& data_;
  const BundleProblemOptions& options_;
  BundleState& s_;
  ceres::Problem problem_;
};

// Inverts the normal matrix of the free parameters: the covariance of [lens, pose, fans], which are whole
// blocks, and the planes' heights.
void FindUncertainties(ceres::Problem* problem, BundleSolution* out) {
  BundleState& state = out->state;
  std::vector<double*> blocks = {state.lens.value.data(), state.camera_from_world.value.data()};
  for (auto& fan : state.fans) blocks.push_back(fan.value.data());
  const auto size =
      static_cast<Eigen::Index>(kLensSize + kPoseSize + kFanSize * static_cast<int>(state.fans.size()));
  std::vector<Eigen::Index> plane_at(state.planes.size(), -1);
  Eigen::Index at = size;
  for (std::size_t i = 0; i < state.planes.size(); ++i) {
    if (problem->IsParameterBlockConstant(state.planes[i].data())) continue;
    blocks.push_back(state.planes[i].data());
    plane_at[i] = at;
    at += kPlaneSize;
  }
  std::vector<double*> all;
  problem->GetParameterBlocks(&all);
  for (double* block : all) {
    const bool known = std::find(blocks.begin(), blocks.end(), block) != blocks.end();
    if (!known && !problem->IsParameterBlockConstant(block)) blocks.push_back(block);
  }
  ceres::Problem::EvaluateOptions evaluate;
  evaluate.num_threads = 1;
  evaluate.parameter_blocks = blocks;
  ceres::CRSMatrix jacobian;
  problem->Evaluate(evaluate, nullptr, nullptr, nullptr, &jacobian);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(jacobian.num_cols, jacobian.num_cols);
  for (int r = 0; r < jacobian.num_rows; ++r) {
    const int from = jacobian.rows[static_cast<std::size_t>(r)],
              to = jacobian.rows[static_cast<std::size_t>(r) + 1];
    for (int i = from; i < to; ++i) {
      const auto a = static_cast<std::size_t>(i);
      for (int k = from; k < to; ++k) {
        const auto b = static_cast<std::size_t>(k);
        normal(jacobian.cols[a], jacobian.cols[b]) += jacobian.values[a] * jacobian.values[b];
      }
    }
  }
  // What nothing was seen of has an empty column; it stays apart. Columns of equal length keep digits.
  std::vector<char> seen(static_cast<std::size_t>(normal.cols()), 1);
  for (Eigen::Index i = 0; i < normal.cols(); ++i) {
    if (normal(i, i) > 0.0) continue;
    seen[static_cast<std::size_t>(i)] = 0;
    normal(i, i) = 1.0;
  }
  const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  const Eigen::MatrixXd inverse =
      scale.asDiagonal() * scaled.ldlt().solve(Eigen::MatrixXd::Identity(scaled.rows(), scaled.cols())) *
      scale.asDiagonal();
  const double factor = std::max(1.0, out->variance_factor);
  out->covariance = factor * inverse.topLeftCorner(size, size);
  out->height_sd.assign(state.planes.size(), 0.0);
  for (std::size_t i = 0; i < plane_at.size(); ++i) {
    const Eigen::Index k = plane_at[i];
    if (k >= 0 && seen[static_cast<std::size_t>(k)])
      out->height_sd[i] = std::sqrt(std::max(0.0, factor * inverse(k, k)));
  }
}

}  // namespace

Result<BundleSolution> SolveBundle(const BundleData& data, const BundleState& start,
                                   const BundleProblemOptions& options, const Context& context) {
  BundleSolution out;
  out.state = start;
  BundleBuilder builder(data, options, &out.state);
  ceres::Problem& problem = builder.problem();
  StopWhenCancelled stop(context);
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.num_threads = 1;  // the same bytes every time
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = 1e-9;
  solver.parameter_tolerance = 1e-10;
  solver.logging_type = ceres::SILENT;
  solver.callbacks.push_back(&stop);
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  if (!summary.IsSolutionUsable()) {
    return BadInput("the stripes and chessboards do not determine the device; capture the series again");
  }
  out.cost = summary.final_cost;
  const double freedom =
      std::max(1, summary.num_residuals_reduced - summary.num_effective_parameters_reduced);
  out.variance_factor = 2.0 * summary.final_cost / freedom;
  if (options.uncertainties) FindUncertainties(&problem, &out);
  return out;
}

double OrderMiss(const BundleState& state, const SheetPoint& p) {
  const FanParameters& fan = state.fans[static_cast<std::size_t>(p.laser)];
  const Eigen::Vector3d world = bundle::PointOnPlane<double>(
      state.lens.value.data(), state.camera_from_world.start, state.camera_from_world.value.data(),
      state.planes[static_cast<std::size_t>(p.plane)].data(), {p.u, p.v});
  return bundle::OrderAt<double>(fan.start, fan.value.data(), world) - p.order;
}

}  // namespace dorsum
