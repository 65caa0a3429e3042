// SPDX-License-Identifier: Apache-2.0
#include "calibration/corner_model.h"

#include "calibration/turn.h"

namespace dorsum {

CornerModel::CornerModel(const LensParameters& lens, const PoseParameters& camera_from_world,
                         const PoseParameters& world_from_board, const std::array<double, kBoardBowSize>& bow)
    : lens_(lens), bow_(bow) {
  const auto read = [](const PoseParameters& pose, Eigen::Matrix3d* rotation, Eigen::Matrix3d* growth,
                       Eigen::Vector3d* at) {
    const Eigen::Vector3d turn(pose.value[0], pose.value[1], pose.value[2]);
    *rotation = pose.start * TurnMatrix(turn);
    *growth = TurnGrowth(turn);
    *at = {pose.value[3], pose.value[4], pose.value[5]};
  };
  read(camera_from_world, &camera_, &camera_turn_, &camera_at_);
  read(world_from_board, &board_, &board_turn_, &board_at_);
}

Eigen::Vector2d CornerModel::Pixel(const Eigen::Vector3d& on_board, const Eigen::Vector2d& share,
                                   CornerDerivatives* derivatives) const {
  const Eigen::Vector3d sag(share.x() * share.x(), share.x() * share.y(), share.y() * share.y());
  Eigen::Vector3d p = on_board;
  p.z() += sag[0] * bow_[0] + sag[1] * bow_[1] + sag[2] * bow_[2];
  const Eigen::Vector3d world = board_ * p + board_at_;
  const Eigen::Vector3d q = camera_ * world + camera_at_;
  const auto& k = lens_.value;
  const double x = q.x() / q.z(), y = q.y() / q.z(), r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k[4] + r2 * (k[5] + r2 * k[8]));
  const Eigen::Vector2d d(x * radial + 2.0 * k[6] * x * y + k[7] * (r2 + 2.0 * x * x),
                          y * radial + k[6] * (r2 + 2.0 * y * y) + 2.0 * k[7] * x * y);
  const double fx = k[0], fy = k[1];

  const double slope = 2.0 * (k[4] + r2 * (2.0 * k[5] + r2 * 3.0 * k[8]));
  const double xx = radial + slope * x * x + 2.0 * k[6] * y + 6.0 * k[7] * x;
  const double xy = slope * x * y + 2.0 * k[6] * x + 2.0 * k[7] * y;
  const double yy = radial + slope * y * y + 6.0 * k[6] * y + 2.0 * k[7] * x;
  Eigen::Matrix<double, 2, 3> by_camera;  // by q
  by_camera << fx * xx, fx * xy, -fx * (xx * x + xy * y), fy * xy, fy * yy, -fy * (xy * x + yy * y);
  by_camera /= q.z();
  const Eigen::Matrix<double, 2, 3> by_world = by_camera * camera_;
  const Eigen::Matrix<double, 2, 3> by_board = by_world * board_;

  CornerDerivatives& out = *derivatives;
  out.leftCols<kLensSize>() << d.x(), 0.0, 1.0, 0.0, fx * x * r2, fx * x * r2 * r2, fx * 2.0 * x * y,
      fx * (r2 + 2.0 * x * x), fx * x * r2 * r2 * r2,  //
      0.0, d.y(), 0.0, 1.0, fy * y * r2, fy * y * r2 * r2, fy * (r2 + 2.0 * y * y), fy * 2.0 * x * y,
      fy * y * r2 * r2 * r2;
  out.middleCols<3>(kCornerPose) = -by_world * Cross(world) * camera_turn_;
  out.middleCols<3>(kCornerPose + 3) = by_camera;
  out.middleCols<3>(kCornerBoard) = -by_board * Cross(p) * board_turn_;
  out.middleCols<3>(kCornerBoard + 3) = by_world;
  out.middleCols<3>(kCornerBow) = by_board.col(2) * sag.transpose();
  return {fx * d.x() + k[2], fy * d.y() + k[3]};
}

}  // namespace dorsum
