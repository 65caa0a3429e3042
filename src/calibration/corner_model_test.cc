// SPDX-License-Identifier: Apache-2.0
#include "calibration/corner_model.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "calibration/bundle_device_test.h"

namespace dorsum {
namespace {

TEST(CornerModel, SeesWhatTheCameraSees) {
  const BundleFixture device;
  CornerDerivatives derivatives;
  for (std::size_t i = 0; i < device.data.boards.size(); ++i) {
    const CornerModel model(device.truth.lens, device.truth.camera_from_world,
                            device.truth.world_from_board[i], {});
    for (std::size_t k = 0; k < device.data.board_points.size(); ++k) {
      const Eigen::Vector2d pixel = model.Pixel(device.data.board_points[k], {0.0, 0.0}, &derivatives);
      EXPECT_LT((pixel - device.data.boards[i].corners[k]).norm(), 1e-9);
    }
  }
}

TEST(CornerModel, DerivativesAreThoseOfFiniteDifferences) {
  const BundleFixture device;
  LensParameters lens = device.truth.lens;
  PoseParameters pose = device.truth.camera_from_world, board = device.truth.world_from_board[6];
  pose.value[0] = 0.1;
  board.value[1] = -0.2;
  std::array<double, kBoardBowSize> bow{0.1, -0.2, 0.3};
  std::vector<double*> all;
  all.reserve(lens.value.size() + pose.value.size() + board.value.size() + bow.size());
  for (double& x : lens.value) all.push_back(&x);
  for (double& x : pose.value) all.push_back(&x);
  for (double& x : board.value) all.push_back(&x);
  for (double& x : bow) all.push_back(&x);
  const Eigen::Vector3d on_board(30.0, -15.0, 0.0);
  const Eigen::Vector2d share(0.7, -0.5);
  CornerDerivatives derivatives, ignored;
  CornerModel(lens, pose, board, bow).Pixel(on_board, share, &derivatives);
  ASSERT_EQ(static_cast<Eigen::Index>(all.size()), derivatives.cols());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double old = *all[i], step = 1e-6 * std::max(1.0, std::abs(old));
    *all[i] = old + step;
    const Eigen::Vector2d above = CornerModel(lens, pose, board, bow).Pixel(on_board, share, &ignored);
    *all[i] = old - step;
    const Eigen::Vector2d below = CornerModel(lens, pose, board, bow).Pixel(on_board, share, &ignored);
    *all[i] = old;
    const Eigen::Vector2d slope = (above - below) / (2.0 * step);
    EXPECT_LT((derivatives.col(static_cast<Eigen::Index>(i)) - slope).norm(),
              1e-6 * std::max(1.0, slope.norm()))
        << i;
  }
}

}  // namespace
}  // namespace dorsum
