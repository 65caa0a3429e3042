// SPDX-License-Identifier: Apache-2.0
#include "geometry/rigid3.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

Rigid3 Make(double angle, const Eigen::Vector3d& axis, const Eigen::Vector3d& translation) {
  return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), translation};
}

TEST(Rigid3, TransformsChainFromRightToLeft) {
  const Rigid3 a_from_b = Make(0.7, {1, 2, 3}, {4, 5, 6}), b_from_c = Make(-1.1, {0, 1, 1}, {-1, 0, 2});
  const Eigen::Vector3d p_c(0.3, -0.4, 0.5);
  EXPECT_LT(((a_from_b * b_from_c) * p_c - a_from_b * (b_from_c * p_c)).norm(), 1e-12);
}

TEST(Rigid3, TheInverseUndoesOnBothSides) {
  const Rigid3 a_from_b = Make(2.0, {3, -1, 2}, {10, -20, 30});
  const Eigen::Vector3d p(1.0, 2.0, 3.0);
  EXPECT_LT((a_from_b.Inverse() * (a_from_b * p) - p).norm(), 1e-12);
  EXPECT_LT((a_from_b * (a_from_b.Inverse() * p) - p).norm(), 1e-12);
}

}  // namespace
}  // namespace dorsum
