// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <Eigen/Cholesky>

#include "base/median.h"
#include "calibration/bundle_functions.h"
#include "geometry/calibration.h"

namespace dorsum {
namespace {

Eigen::Vector3d PlacePoint(const BundleState& s, const SheetPoint& p) {
  return bundle::PointOnPlane<double>(s.lens.value.data(), s.camera_from_world.start,
                                      s.camera_from_world.value.data(),
                                      s.planes[static_cast<std::size_t>(p.plane)].data(), {p.u, p.v});
}

// Shift, slope along y and stretch along x of the misses, fitted with weights that drop outliers.
double LowOrderOff(const BundleState& state, const std::vector<SheetPoint>& points) {
  std::vector<Eigen::Vector3d> rows;
  std::vector<double> misses;
  for (const SheetPoint& p : points) {
    const Eigen::Vector3d at = PlacePoint(state, p);
    rows.emplace_back(1.0, at.x() / 100.0, at.y() / 100.0);
    misses.push_back(OrderMiss(state, p) / p.orders_per_px * p.mm_per_px);
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
  constexpr int kThin = 3;
  std::vector<SeriesCheck> checks;
  for (std::size_t k = 0; k < state.fans.size(); ++k) {
    const BundleData all = OneLaser(data, static_cast<int>(k), kThin);
    // Heights as given, since a laser that moved pulls at those that were fitted.
    BundleState start = state;
    start.fans = {state.fans[k]};
    for (std::size_t i = 1; i < start.planes.size(); ++i) {
      if (data.planes[i].sd_mm < kUnknownHeightSd) start.planes[i] = {data.planes[i].given_mm, 0.0, 0.0};
    }
    std::set<int> sources;
    for (const SheetPoint& p : all.points) sources.insert(p.source);
    for (const int source : sources) {
      BundleData rest = all;
      std::vector<SheetPoint> left;
      for (const SheetPoint& p : all.points) {
        if (p.source == source) left.push_back(p);
      }
      std::erase_if(rest.points, [source](const SheetPoint& p) { return p.source == source; });
      std::set<int> planes;
      for (const SheetPoint& p : rest.points) planes.insert(p.plane);
      if (planes.size() < 2 || left.size() < 50) continue;
      BundleProblemOptions fans_only = options;
      fans_only.move_camera = false;
      fans_only.uncertainties = false;
      DORSUM_ASSIGN_OR_RETURN(const BundleSolution without, SolveBundle(rest, start, fans_only, context));
      checks.push_back({static_cast<int>(k), source, LowOrderOff(without.state, left),
                        std::sqrt(without.variance_factor)});
    }
  }
  return checks;
}

double HeightUncertainty(const BundleState& state, const Eigen::MatrixXd& covariance, int fan, int min_order,
                         int max_order, double min_height_mm, double max_height_mm) {
  constexpr int kCamera = kLensSize + kPoseSize, kAll = kCamera + kFanSize;
  using Jet = ceres::Jet<double, kAll>;
  const FanParameters& f = state.fans[static_cast<std::size_t>(fan)];
  std::array<Jet, kLensSize> lens;
  std::array<Jet, kPoseSize> pose;
  std::array<Jet, kFanSize> sheets;
  for (int i = 0; i < kLensSize; ++i)
    lens[static_cast<std::size_t>(i)] = Jet(state.lens.value[static_cast<std::size_t>(i)], i);
  for (int i = 0; i < kPoseSize; ++i) {
    pose[static_cast<std::size_t>(i)] =
        Jet(state.camera_from_world.value[static_cast<std::size_t>(i)], kLensSize + i);
  }
  for (int i = 0; i < kFanSize; ++i)
    sheets[static_cast<std::size_t>(i)] = Jet(f.value[static_cast<std::size_t>(i)], kCamera + i);
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
    for (int column = 1; column < 10; ++column) {
      for (int row = 0; row < 5; ++row) {
        const Eigen::Vector2d pixel(0.1 * column * (state.width - 1), 0.25 * row * (state.height - 1));
        const auto order_at = [&](double height) {
          const std::array<Jet, kPlaneSize> plane = {Jet(height), Jet(0.0), Jet(0.0)};
          return bundle::OrderAt<Jet>(f.start, sheets.data(),
                                      bundle::PointOnPlane<Jet>(lens.data(), state.camera_from_world.start,
                                                                pose.data(), plane.data(), pixel));
        };
        const Jet here = order_at(z);
        if (!std::isfinite(here.a) || here.a < min_order - 0.5 || here.a > max_order + 0.5) continue;
        const double slope = (order_at(z + 0.05).a - order_at(z - 0.05).a) / 0.1;
        const double variance = here.v.dot(part * here.v) / (slope * slope);
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
