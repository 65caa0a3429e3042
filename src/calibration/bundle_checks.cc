// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <Eigen/Cholesky>

#include "base/median.h"
#include "base/parallel.h"
#include "calibration/stripe_models.h"
#include "geometry/calibration.h"

namespace dorsum {
namespace {

// Shift, slope along y and stretch along x of the misses, fitted with weights that drop outliers.
double LowOrderOff(const BundleState& state, const std::vector<SheetPoint>& points) {
  const StripeModels models(state);
  std::vector<Eigen::Vector3d> rows;
  std::vector<double> misses;
  for (const SheetPoint& p : points) {
    const StripeModel& model = models.Of(p.laser, p.plane);
    const Eigen::Vector3d at = model.Place({p.u, p.v});
    rows.emplace_back(1.0, at.x() / 100.0, at.y() / 100.0);
    misses.push_back((model.Order({p.u, p.v}) - p.order) / p.orders_per_px * p.mm_per_px);
  }
  Eigen::Vector3d fit(Median(misses), 0.0, 0.0);
  for (int pass = 0; pass < 8; ++pass) {
    Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      constexpr double kUsual = 0.05;  // mm
      const double r = (misses[i] - fit.dot(rows[i])) / kUsual;
      const double w = 1.0 / (1.0 + r * r);
      normal += w * rows[i] * rows[i].transpose();
      right += w * misses[i] * rows[i];
    }
    fit = normal.ldlt().solve(right);
  }
  double square = 0.0;
  for (const Eigen::Vector3d& row : rows) square += std::pow(fit.dot(row), 2);
  return std::sqrt(square / static_cast<double>(rows.size()));
}

// One laser's part of a problem, with everything but its fan fixed.
BundleData OneLaser(const BundleData& data, int laser, int thin) {
  BundleData one;
  one.board_points = data.board_points;
  one.planes = data.planes;
  for (HeightPlane& plane : one.planes) plane.sd_mm = 0.0;
  int count = 0;
  for (const SheetPoint& p : data.points) {
    if (p.laser != laser || count++ % thin != 0) continue;
    one.points.push_back(p);
    one.points.back().laser = 0;
  }
  return one;
}

}  // namespace

Result<std::vector<HeightCheck>> CheckHeights(const BundleData& data, const BundleState& state,
                                              const BundleProblemOptions& options, const Context& context) {
  BundleProblemOptions free = options;
  free.free_heights = true;
  free.uncertainties = true;
  DORSUM_ASSIGN_OR_RETURN(const BundleSolution solution, SolveBundle(data, state, free, context));
  std::vector<HeightCheck> checks;
  for (std::size_t i = 1; i < data.planes.size(); ++i) {
    if (!(solution.height_sd[i] > 0.0)) continue;  // nothing was seen on it
    checks.push_back(
        {static_cast<int>(i), data.planes[i].given_mm, solution.state.planes[i][0], solution.height_sd[i]});
  }
  return checks;
}

Result<BoardCheck> CheckBoard(const BundleData& data, const BundleState& state,
                              const BundleProblemOptions& options, const Context& context) {
  BundleProblemOptions flat = options;
  flat.use_points = false;
  flat.bow_boards = false;
  DORSUM_ASSIGN_OR_RETURN(const BundleSolution level, SolveBundle(data, state, flat, context));
  BundleProblemOptions bent = flat;
  bent.bow_boards = true;
  DORSUM_ASSIGN_OR_RETURN(const BundleSolution bowed, SolveBundle(data, level.state, bent, context));
  BoardCheck check;
  check.bow = bowed.state.board_bow;
  check.sag_mm = std::max(std::abs(check.bow[0] + check.bow[1] + check.bow[2]),
                          std::abs(check.bow[0] - check.bow[1] + check.bow[2]));
  const double gain = 2.0 * (level.cost - bowed.cost) / std::max(1e-12, bowed.variance_factor);
  check.significance = std::sqrt(std::max(0.0, gain));
  return check;
}

Result<std::vector<SeriesCheck>> CheckSeries(const BundleData& data, const BundleState& state,
                                             const BundleProblemOptions& options, const Context& context) {
  struct Task {
    int laser = 0, source = 0;
    const BundleData* all = nullptr;  // of the laser
    std::optional<SeriesCheck> check;
    Status status;
  };
  constexpr int kThin = 3;
  std::vector<BundleData> lasers;
  for (std::size_t k = 0; k < state.fans.size(); ++k)
    lasers.push_back(OneLaser(data, static_cast<int>(k), kThin));
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < lasers.size(); ++k) {
    std::set<int> sources;
    for (const SheetPoint& p : lasers[k].points) sources.insert(p.source);
    for (const int source : sources) tasks.push_back({static_cast<int>(k), source, &lasers[k], {}, {}});
  }
  Context quiet = context;
  quiet.progress = nullptr;
  quiet.threads = 1;
  ParallelFor(context, 0, static_cast<std::int64_t>(tasks.size()), [&](std::int64_t i) {
    Task& task = tasks[static_cast<std::size_t>(i)];
    // Heights as given, since a laser that moved pulls at those that were fitted.
    BundleState start = state;
    start.fans = {state.fans[static_cast<std::size_t>(task.laser)]};
    for (std::size_t plane = 1; plane < start.planes.size(); ++plane) {
      if (data.planes[plane].sd_mm < kUnknownHeightSd)
        start.planes[plane] = {data.planes[plane].given_mm, 0.0, 0.0};
    }
    BundleData rest = *task.all;
    std::vector<SheetPoint> left;
    std::set<int> planes;
    std::erase_if(rest.points, [&](const SheetPoint& p) {
      const bool out = p.source == task.source;
      if (out) left.push_back(p);
      if (!out) planes.insert(p.plane);
      return out;
    });
    if (planes.size() < 2 || left.size() < 50) return;
    BundleProblemOptions fans_only = options;
    fans_only.move_camera = false;
    fans_only.uncertainties = false;
    const Result<BundleSolution> without = SolveBundle(rest, start, fans_only, quiet);
    if (!without.ok()) {
      task.status = without.error();
      return;
    }
    task.check = SeriesCheck{task.laser, task.source, LowOrderOff(without->state, left),
                             std::sqrt(without->variance_factor)};
  });
  std::vector<SeriesCheck> checks;
  for (const Task& task : tasks) {
    DORSUM_RETURN_IF_ERROR(task.status);
    if (task.check) checks.push_back(*task.check);
  }
  return checks;
}

double HeightUncertainty(const BundleState& state, const Eigen::MatrixXd& covariance, int fan, int min_order,
                         int max_order, double min_height_mm, double max_height_mm) {
  constexpr int kCamera = kLensSize + kPoseSize, kAll = kCamera + kFanSize;
  static_assert(kCamera == kStripeFan && kAll == kStripePlane);
  // The covariance of just these parameters.
  Eigen::MatrixXd part(kAll, kAll);
  const int from = kCamera + kFanSize * fan;
  part.topLeftCorner(kCamera, kCamera) = covariance.topLeftCorner(kCamera, kCamera);
  part.topRightCorner(kCamera, kFanSize) = covariance.block(0, from, kCamera, kFanSize);
  part.bottomLeftCorner(kFanSize, kCamera) = covariance.block(from, 0, kFanSize, kCamera);
  part.bottomRightCorner(kFanSize, kFanSize) = covariance.block(from, from, kFanSize, kFanSize);
  double sum = 0.0, count = 0.0;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double z = min_height_mm + share * (max_height_mm - min_height_mm);
    const StripeModel model(state.lens, state.camera_from_world, state.fans[static_cast<std::size_t>(fan)],
                            {z, 0.0, 0.0});
    for (int column = 1; column < 10; ++column) {
      for (int row = 0; row < 5; ++row) {
        const Eigen::Vector2d pixel(0.1 * column * (state.width - 1), 0.25 * row * (state.height - 1));
        StripeSearch search;
        StripeDerivatives derivatives{};
        const double order = model.Order(pixel, true, &search, &derivatives);
        if (!std::isfinite(order) || order < min_order - 0.5 || order > max_order + 0.5) continue;
        const Eigen::Map<const Eigen::Matrix<double, kAll, 1>> by(derivatives.data());
        const double variance = by.dot(part * by) / std::pow(derivatives[kStripePlane], 2);
        if (!std::isfinite(variance)) continue;
        sum += std::max(0.0, variance);
        count += 1.0;
      }
    }
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

double LeftPattern(const std::vector<PatternPoint>& points) {
  constexpr double kStretch = 25.0, kLeastPoints = 4.0;  // mm of y
  struct Cell {
    double n = 0.0, sum = 0.0;
  };
  std::map<std::tuple<int, int, int>, Cell> cells;  // by height, stretch and order
  for (const PatternPoint& p : points) {
    if (std::abs(p.miss_mm) > 0.5) continue;
    Cell& cell = cells[{static_cast<int>(std::lround(p.height_mm * 10.0)),
                        static_cast<int>(std::floor(p.y_mm / kStretch)), p.order}];
    cell.n += 1.0;
    cell.sum += p.miss_mm;
  }
  double sum = 0.0, count = 0.0;
  for (const auto& [key, cell] : cells) {
    const auto& [height, stretch, order] = key;
    const auto next = cells.find({height, stretch, order + 1});
    if (next == cells.end() || cell.n < kLeastPoints || next->second.n < kLeastPoints) continue;
    sum += cell.sum / cell.n * next->second.sum / next->second.n;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(std::max(0.0, sum / count)) : 0.0;
}

}  // namespace dorsum
