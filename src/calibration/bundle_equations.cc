// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_equations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "base/parallel.h"
#include "calibration/corner_model.h"
#include "calibration/turn.h"
#include "calibration/weighted_rows.h"

namespace dorsum {
struct BundleEquations::Piece {
  int board = -1;  // or
  int fan = 0, plane = 0;
  std::size_t first = 0, last = 0;  // of sorted_
};

struct BundleEquations::Sum {
  double cost = 0.0;
  Eigen::MatrixXd squares;  // lower half, the residuals last
};

BundleEquations::BundleEquations(const BundleData& data, const BundleProblemOptions& options,
                                 const BundleState& state)
    : data_(data), options_(options) {
  layout_.fans = static_cast<int>(state.fans.size());
  layout_.planes = static_cast<int>(state.planes.size());
  layout_.boards = options.move_camera ? static_cast<int>(data.boards.size()) : 0;
  FindFree();
  if (options.use_points) SortPoints();
  for (int i = 0; i < layout_.boards; ++i) {
    pieces_.push_back({i});
    const BoardView& view = data.boards[static_cast<std::size_t>(i)];
    residuals_ += 2 * static_cast<int>(view.corners.size()) + (view.plane >= 0 ? 3 : 0);
  }
}

BundleEquations::~BundleEquations() = default;

void BundleEquations::FindFree() {
  const auto add = [this](int from, int count) {
    for (int i = 0; i < count; ++i) free_.push_back(from + i);
  };
  if (options_.move_camera) add(0, kLensSize + kPoseSize);
  for (int i = 0; i < layout_.fans && options_.use_points; ++i) {
    add(BundleLayout::Fan(i), kFanSize);
    residuals_ += kFanSize;
  }
  for (int i = 1; i < layout_.planes; ++i) {
    if (data_.planes[static_cast<std::size_t>(i)].sd_mm <= 0.0) continue;
    add(layout_.Plane(i), kPlaneSize);
    residuals_ += kPlaneSize;
  }
  if (options_.bow_boards && options_.move_camera) add(layout_.Bow(), kBoardBowSize);
  for (int i = 0; i < layout_.boards; ++i) {
    // The first board gives the world its origin and for the time being its x axis.
    for (int k = 0; k < kPoseSize; ++k) {
      if (i > 0 || k < 2 || k > 4) free_.push_back(layout_.Board(i) + k);
    }
  }
}

void BundleEquations::SortPoints() {
  constexpr std::size_t kPiece = 512;
  const auto& points = data_.points;
  sorted_.resize(points.size());
  searches_.resize(points.size());
  residuals_ += static_cast<int>(points.size());
  std::iota(sorted_.begin(), sorted_.end(), std::size_t{0});
  const auto key = [&points](std::size_t i) { return std::tuple(points[i].laser, points[i].plane); };
  std::stable_sort(sorted_.begin(), sorted_.end(),
                   [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
  for (std::size_t first = 0; first < sorted_.size();) {
    std::size_t last = first + 1;
    while (last < sorted_.size() && last < first + kPiece && key(sorted_[last]) == key(sorted_[first]))
      ++last;
    const SheetPoint& p = points[sorted_[first]];
    pieces_.push_back({-1, p.laser, p.plane, first, last});
    first = last;
  }
}

void BundleEquations::Forget() { std::fill(searches_.begin(), searches_.end(), StripeSearch{}); }

void BundleEquations::AddPoints(const BundleState& state, const Piece& piece, Sum* sum) {
  const StripeModel model(state.lens, state.camera_from_world,
                          state.fans[static_cast<std::size_t>(piece.fan)],
                          state.planes[static_cast<std::size_t>(piece.plane)]);
  const double scale = options_.loss_scale;
  sum->squares.setZero(kStripeSize + 1, kStripeSize + 1);
  WeightedRows<kStripeSize> rows(options_.move_camera ? 0 : kStripeFan);
  StripeDerivatives derivatives{};
  for (std::size_t k = piece.first; k < piece.last; ++k) {
    const SheetPoint& p = data_.points[sorted_[k]];
    const double sd = std::hypot(p.sd_px, options_.point_sd_px) * p.orders_per_px;
    const double order = model.Order({p.u, p.v}, options_.move_camera, &searches_[k], &derivatives);
    const double residual = (order - p.order) / sd;
    const double root = std::sqrt(CauchyWeight(residual * residual, scale));
    sum->cost += CauchyCost(residual * residual, scale);
    rows.Add(derivatives, root / sd, root * residual, &sum->squares);
  }
  rows.Flush(&sum->squares);
}

void BundleEquations::AddCorners(const BundleState& state, const Piece& piece, Sum* sum) const {
  const BoardView& view = data_.boards[static_cast<std::size_t>(piece.board)];
  const CornerModel model(state.lens, state.camera_from_world,
                          state.world_from_board[static_cast<std::size_t>(piece.board)], state.board_bow);
  Eigen::Vector2d half(1e-9, 1e-9);
  for (const auto& p : data_.board_points) half = half.cwiseMax(p.head<2>().cwiseAbs());
  const double scale = options_.loss_scale, sd = options_.corner_sd_px;
  sum->squares.setZero(kCornerSize + 1, kCornerSize + 1);
  WeightedRows<kCornerSize> rows(0);
  CornerDerivatives derivatives;
  for (std::size_t k = 0; k < view.corners.size(); ++k) {
    const Eigen::Vector3d& p = data_.board_points[k];
    const Eigen::Vector2d residual =
        (model.Pixel(p, p.head<2>().cwiseQuotient(half), &derivatives) - view.corners[k]) / sd;
    const double square = residual.squaredNorm(), root = std::sqrt(CauchyWeight(square, scale));
    sum->cost += CauchyCost(square, scale);
    for (int i = 0; i < 2; ++i) rows.Add(derivatives.row(i), root / sd, root * residual[i], &sum->squares);
  }
  rows.Flush(&sum->squares);
}

// A board that lies on a plane: its centre's height and its slopes are the plane's.
void BundleEquations::AddLying(const BundleState& state, NormalEquations* out) const {
  for (int i = 0; i < layout_.boards; ++i) {
    const int plane_index = data_.boards[static_cast<std::size_t>(i)].plane;
    if (plane_index < 0) continue;
    const PoseParameters& board = state.world_from_board[static_cast<std::size_t>(i)];
    const auto& plane = state.planes[static_cast<std::size_t>(plane_index)];
    const Eigen::Vector3d turn(board.value[0], board.value[1], board.value[2]);
    const Eigen::Matrix3d rotation = board.start * TurnMatrix(turn);
    const Eigen::Vector3d up = rotation.col(2);
    const Eigen::Matrix3d up_by_turn = -rotation * Cross(Eigen::Vector3d::UnitZ()) * TurnGrowth(turn);
    Eigen::Matrix<double, 3, kPoseSize + kPlaneSize> by;
    by << 0.0, 0.0, 0.0, -plane[1], -plane[2], 1.0, -1.0, -board.value[3], -board.value[4],  //
        up_by_turn.row(0), 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,                                     //
        up_by_turn.row(1), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
    Eigen::Vector3d residual(
        board.value[5] - (plane[0] + plane[1] * board.value[3] + plane[2] * board.value[4]),
        up.x() + plane[1], up.y() + plane[2]);
    const Eigen::Vector3d weight(1.0 / options_.lying_sd_mm, 1.0 / options_.lying_sd_rad,
                                 1.0 / options_.lying_sd_rad);
    by = weight.asDiagonal() * by;
    residual = residual.cwiseProduct(weight);
    const Eigen::Matrix<double, kPoseSize + kPlaneSize, kPoseSize + kPlaneSize> squares = by.transpose() * by;
    const int b = layout_.Board(i), p = layout_.Plane(plane_index);
    out->cost += 0.5 * residual.squaredNorm();
    out->gradient.segment<kPoseSize>(b) += by.leftCols<kPoseSize>().transpose() * residual;
    out->gradient.segment<kPlaneSize>(p) += by.rightCols<kPlaneSize>().transpose() * residual;
    out->normal.block<kPoseSize, kPoseSize>(b, b) += squares.topLeftCorner<kPoseSize, kPoseSize>();
    out->normal.block<kPlaneSize, kPoseSize>(p, b) += squares.bottomLeftCorner<kPlaneSize, kPoseSize>();
    out->normal.block<kPlaneSize, kPlaneSize>(p, p) += squares.bottomRightCorner<kPlaneSize, kPlaneSize>();
  }
}

void BundleEquations::AddPriors(const BundleState& state, NormalEquations* out) const {
  // x ~ mean +- sd
  const auto add = [out](int at, double x, double mean, double sd) {
    const double residual = (x - mean) / sd;
    out->cost += 0.5 * residual * residual;
    out->gradient[at] += residual / sd;
    out->normal(at, at) += 1.0 / (sd * sd);
  };
  for (int i = 1; i < layout_.planes; ++i) {
    const HeightPlane& given = data_.planes[static_cast<std::size_t>(i)];
    const auto& plane = state.planes[static_cast<std::size_t>(i)];
    if (given.sd_mm <= 0.0) continue;
    const int at = layout_.Plane(i);
    if (!options_.free_heights) add(at, plane[0], given.given_mm, given.sd_mm);
    // A plane of 200 mm that is off by sd at its ends.
    add(at + 1, plane[1], 0.0, 0.01 * given.sd_mm);
    add(at + 2, plane[2], 0.0, 0.01 * given.sd_mm);
  }
  for (int i = 0; i < layout_.fans && options_.use_points; ++i) {
    const auto& fan = state.fans[static_cast<std::size_t>(i)].value;
    const int at = BundleLayout::Fan(i);
    // mm, rad and cosines that a device can have; the data decide wherever they can.
    constexpr double kDistance = 15.0, kTurn = 0.1, kAlpha = 0.3, kSkew = 0.02, kBow = 0.15;
    add(at + kFanTurn, fan[kFanTurn], 0.0, kTurn);
    add(at + kFanTurn + 1, fan[kFanTurn + 1], 0.0, kTurn);
    add(at + kFanDistance, fan[kFanDistance], kDistance, kDistance);
    add(at + kFanAlpha, fan[kFanAlpha], 0.0, kAlpha);
    add(at + kFanSkew, fan[kFanSkew], 0.0, kSkew);
    add(at + kFanBow, fan[kFanBow], 0.0, kBow);
  }
}

NormalEquations BundleEquations::At(const BundleState& state, const Context& context) {
  std::vector<Sum> sums(pieces_.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(pieces_.size()), [&](std::int64_t i) {
    const Piece& piece = pieces_[static_cast<std::size_t>(i)];
    Sum* sum = &sums[static_cast<std::size_t>(i)];
    if (piece.board < 0) {
      AddPoints(state, piece, sum);
    } else {
      AddCorners(state, piece, sum);
    }
  });
  NormalEquations out;
  out.gradient.setZero(layout_.Size());
  out.normal.setZero(layout_.Size(), layout_.Size());
  std::vector<int> place;  // of a sum's columns in the list of all parameters
  const auto add = [&place](int from, int count) {
    for (int i = 0; i < count; ++i) place.push_back(from + i);
  };
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const Piece& piece = pieces_[k];
    place.clear();
    add(0, kLensSize + kPoseSize);
    if (piece.board < 0) {
      add(BundleLayout::Fan(piece.fan), kFanSize);
      add(layout_.Plane(piece.plane), kPlaneSize);
    } else {
      add(layout_.Board(piece.board), kPoseSize);
      add(layout_.Bow(), kBoardBowSize);
    }
    const Sum& sum = sums[k];
    const auto size = static_cast<Eigen::Index>(place.size());
    out.cost += sum.cost;
    for (Eigen::Index c = 0; c < size; ++c) {
      const int column = place[static_cast<std::size_t>(c)];
      out.gradient[column] += sum.squares(size, c);
      for (Eigen::Index r = c; r < size; ++r) {
        const int row = place[static_cast<std::size_t>(r)];
        out.normal(std::min(row, column), std::max(row, column)) += sum.squares(r, c);
      }
    }
  }
  if (layout_.boards > 0) AddLying(state, &out);
  AddPriors(state, &out);
  // So far only the upper half was summed.
  out.normal.triangularView<Eigen::StrictlyLower>() = out.normal.transpose();
  return out;
}

}  // namespace dorsum
