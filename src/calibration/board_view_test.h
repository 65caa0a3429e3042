// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "geometry/camera.h"

namespace dorsum {

// Draws a chessboard through a homography image_from_board, BGR, as soft as a lens leaves it. Board
// coordinates are mm about the board's centre, x along its rows, y downwards.
inline cv::Mat DrawBoard(cv::Size image, cv::Size inner, double square_mm,
                         const cv::Matx33d& image_from_board, int samples = 4) {
  const cv::Matx33d board_from_image = image_from_board.inv();
  cv::Mat fine(image * samples, CV_8UC3);
  const double half_x = 0.5 * (inner.width - 1) * square_mm, half_y = 0.5 * (inner.height - 1) * square_mm;
  for (int v = 0; v < fine.rows; ++v) {
    for (int u = 0; u < fine.cols; ++u) {
      // Centres of samples about the centre of their pixel.
      const cv::Vec3d p =
          board_from_image * cv::Vec3d((u + 0.5) / samples - 0.5, (v + 0.5) / samples - 0.5, 1.0);
      const double column = (p[0] / p[2] + half_x) / square_mm, row = (p[1] / p[2] + half_y) / square_mm;
      const bool on_board = column > -1.0 && row > -1.0 && column < inner.width && row < inner.height;
      const bool dark = on_board && ((cvFloor(column) + cvFloor(row)) & 1) == 0;
      fine.at<cv::Vec3b>(v, u) = dark ? cv::Vec3b(35, 30, 32) : cv::Vec3b(205, 215, 210);
    }
  }
  cv::Mat out;
  cv::resize(fine, out, image, 0.0, 0.0, cv::INTER_AREA);
  cv::GaussianBlur(out, out, {}, 0.8);
  return out;
}

// Where that homography puts the inner corners, row by row.
inline std::vector<cv::Point2d> TrueCorners(cv::Size inner, double square_mm,
                                            const cv::Matx33d& image_from_board) {
  std::vector<cv::Point2d> corners;
  for (int r = 0; r < inner.height; ++r) {
    for (int c = 0; c < inner.width; ++c) {
      const cv::Vec3d p = image_from_board * cv::Vec3d((c - 0.5 * (inner.width - 1)) * square_mm,
                                                       (r - 0.5 * (inner.height - 1)) * square_mm, 1.0);
      corners.emplace_back(p[0] / p[2], p[1] / p[2]);
    }
  }
  return corners;
}

// The homography of a board in a camera without distortion; `camera_from_board` has the board's z pointing
// away from the camera.
inline cv::Matx33d BoardHomography(const Camera& camera, const Rigid3& camera_from_board) {
  const auto& r = camera_from_board.rotation;
  const auto& t = camera_from_board.translation;
  const cv::Matx33d k(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const cv::Matx33d pose(r(0, 0), r(0, 1), t.x(), r(1, 0), r(1, 1), t.y(), r(2, 0), r(2, 1), t.z());
  return k * pose;
}

// Poses camera_from_board of a series of views: the first flat, the others tilted about changing axes.
inline Rigid3 TiltedBoard(int view, double distance_mm) {
  const double turn = 0.52 * view;
  const double tilt = view == 0 ? 0.0 : 0.35 + 0.02 * view;
  Rigid3 pose;
  pose.rotation =
      Eigen::AngleAxisd(tilt, Eigen::Vector3d(std::cos(turn), std::sin(turn), 0.0)).toRotationMatrix();
  pose.translation = {view == 0 ? 6.0 : 15.0 * std::cos(2.0 * turn), 8.0 * std::sin(turn), distance_mm};
  return pose;
}

}  // namespace dorsum
