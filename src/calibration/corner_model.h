// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "calibration/bundle_model.h"

namespace dorsum {

// Derivatives of a corner's pixel by lens, camera_from_world, world_from_board and the board's bow, in this
// order.
inline constexpr int kCornerPose = kLensSize, kCornerBoard = kCornerPose + kPoseSize,
                     kCornerBow = kCornerBoard + kPoseSize, kCornerSize = kCornerBow + kBoardBowSize;
using CornerDerivatives = Eigen::Matrix<double, 2, kCornerSize, Eigen::RowMajor>;

// Where a camera sees the corners of one board.
class CornerModel {
 public:
  CornerModel(const LensParameters& lens, const PoseParameters& camera_from_world,
              const PoseParameters& world_from_board, const std::array<double, kBoardBowSize>& bow);

  // Of a place on the board, mm, which is `share` of the way to the board's sides, -1 to 1.
  Eigen::Vector2d Pixel(const Eigen::Vector3d& on_board, const Eigen::Vector2d& share,
                        CornerDerivatives* derivatives) const;

 private:
  LensParameters lens_;
  std::array<double, kBoardBowSize> bow_;
  Eigen::Matrix3d camera_, camera_turn_, board_, board_turn_;
  Eigen::Vector3d camera_at_, board_at_;
};

}  // namespace dorsum
