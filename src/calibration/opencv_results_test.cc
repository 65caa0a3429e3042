// SPDX-License-Identifier: Apache-2.0
#include "calibration/opencv_results.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

const cv::Mat kTurn = (cv::Mat_<double>(3, 1) << 0.1, -0.2, 1.3);
const cv::Mat kShift = (cv::Mat_<double>(3, 1) << 10.1, -20.2, 400.3);

TEST(OpencvResultsTest, APoseIsThatOfTheSolver) {
  const Rigid3 pose = PoseFromSolver(kTurn, kShift);
  EXPECT_TRUE(pose.translation.isApprox(Eigen::Vector3d(10.1, -20.2, 400.3), 1e-7));
  const Eigen::AngleAxisd turn(pose.rotation);
  EXPECT_TRUE((turn.angle() * turn.axis()).isApprox(Eigen::Vector3d(0.1, -0.2, 1.3), 1e-6));
}

TEST(OpencvResultsTest, LastDigitsMakeNoDifference) {
  const Rigid3 one = PoseFromSolver(kTurn, kShift);
  const Rigid3 other = PoseFromSolver(kTurn * (1.0 + 1e-12), kShift * (1.0 - 1e-12));
  EXPECT_EQ(one.rotation, other.rotation);
  EXPECT_EQ(one.translation, other.translation);
}

}  // namespace
}  // namespace dorsum
