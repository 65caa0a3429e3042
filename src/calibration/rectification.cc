// SPDX-License-Identifier: Apache-2.0
#include "calibration/rectification.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "calibration/chessboard.h"
#include "calibration/opencv_results.h"

namespace dorsum {
namespace {

Eigen::Vector2d UndistortPixel(const Camera& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d n =
      Undistort(camera, {(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy});
  return {n.x() * camera.fx + camera.cx, n.y() * camera.fy + camera.cy};
}

Eigen::Vector2d DistortedPixel(const Camera& camera, const Eigen::Vector2d& p) {
  const Eigen::Vector2d d =
      Distort(camera, {(p.x() - camera.cx) / camera.fx, (p.y() - camera.cy) / camera.fy});
  return {d.x() * camera.fx + camera.cx, d.y() * camera.fy + camera.cy};
}

Eigen::Vector2d Apply(const cv::Matx33d& h, const Eigen::Vector2d& p) {
  const cv::Vec3d q = h * cv::Vec3d(p.x(), p.y(), 1.0);
  return {q[0] / q[2], q[1] / q[2]};
}

// The part of the plane that is seen along the image's edges.
cv::Rect2d SeenArea(const Camera& camera, const Rectification& r) {
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const double u : {0.0, 0.5, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0}) {
      const Eigen::Vector2d p = PlaneFromPixel(camera, r, {u * (camera.width - 1), v * (camera.height - 1)});
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

}  // namespace

Rectification RectifyFromBoard(const Camera& camera, const std::vector<cv::Point2f>& corners, cv::Size inner,
                               double square_mm) {
  const std::vector<cv::Point3f> board = ChessboardPoints(inner, square_mm);
  std::vector<cv::Point2d> image, plane;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d p = UndistortPixel(camera, {corners[i].x, corners[i].y});
    image.emplace_back(p.x(), p.y());
    plane.emplace_back(board[i].x, board[i].y);
  }
  Rectification r;
  r.plane_from_image = cv::findHomography(image, plane, 0);
  for (double& h : r.plane_from_image.val) h = Settled(h);
  double spacing = 0.0, square_error = 0.0;
  int pairs = 0;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (static_cast<int>(i) % inner.width != 0) {
      spacing += cv::norm(image[i] - image[i - 1]);
      ++pairs;
    }
    const Eigen::Vector2d p = Apply(r.plane_from_image, {image[i].x, image[i].y});
    square_error += std::pow(p.x() - plane[i].x, 2) + std::pow(p.y() - plane[i].y, 2);
  }
  r.px_per_mm = spacing / pairs / square_mm;
  r.rms_mm = std::sqrt(square_error / static_cast<double>(image.size()));
  r.area_mm = SeenArea(camera, r);
  return r;
}

Eigen::Vector2d PlaneFromPixel(const Camera& camera, const Rectification& r, const Eigen::Vector2d& pixel) {
  return Apply(r.plane_from_image, UndistortPixel(camera, pixel));
}

Eigen::Vector2d PixelFromPlane(const Camera& camera, const Rectification& r, const Eigen::Vector2d& mm) {
  return DistortedPixel(camera, Apply(r.plane_from_image.inv(), mm));
}

cv::Mat WarpToPlane(const cv::Mat& image, const Camera& camera, const Rectification& r) {
  // A board seen almost edge-on would ask for an endless picture.
  constexpr double kLargest = 8000.0;
  const cv::Size size(static_cast<int>(std::clamp(r.area_mm.width * r.px_per_mm, 1.0, kLargest)),
                      static_cast<int>(std::clamp(r.area_mm.height * r.px_per_mm, 1.0, kLargest)));
  const cv::Matx33d image_from_plane = r.plane_from_image.inv();
  cv::Mat2f map(size);
  for (int j = 0; j < size.height; ++j) {
    // Along a row, the homogeneous place grows evenly.
    const cv::Vec3d first = image_from_plane * cv::Vec3d(r.area_mm.x, r.area_mm.y + j / r.px_per_mm, 1.0);
    const cv::Vec3d step = image_from_plane * cv::Vec3d(1.0 / r.px_per_mm, 0.0, 0.0);
    auto* row = map[j];
    for (int i = 0; i < size.width; ++i) {
      const cv::Vec3d q = first + i * step;
      const Eigen::Vector2d p = DistortedPixel(camera, {q[0] / q[2], q[1] / q[2]});
      row[i] = {static_cast<float>(p.x()), static_cast<float>(p.y())};
    }
  }
  cv::Mat warped;
  cv::remap(image, warped, map, {}, cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar::all(0));
  return warped;
}

}  // namespace dorsum
