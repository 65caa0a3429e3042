// SPDX-License-Identifier: Apache-2.0
#include "calibration/opencv_results.h"

#include <opencv2/calib3d.hpp>

namespace dorsum {

Rigid3 PoseFromSolver(const cv::Mat& rvec, const cv::Mat& tvec) {
  cv::Vec3d turn;
  cv::Matx33d rotation;
  Rigid3 out;
  for (int i = 0; i < 3; ++i) {
    turn[i] = Settled(rvec.at<double>(i));
    out.translation[i] = Settled(tvec.at<double>(i));
  }
  cv::Rodrigues(turn, rotation);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.rotation(r, c) = rotation(r, c);
  }
  return out;
}

}  // namespace dorsum
