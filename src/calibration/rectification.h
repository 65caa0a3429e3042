// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "geometry/camera.h"

namespace dorsum {

// The inverse perspective of one distance (§3.2): what the camera sees of a plane, as if seen from straight
// above at a fixed scale. Plane coordinates are mm, origin at the centre of the board that lay there.
struct Rectification {
  cv::Matx33d plane_from_image;  // homography from undistorted pixels to the plane, mm
  double px_per_mm = 0.0;  // the pixel-to-millimetre ratio: the board's mean scale in the undistorted image
  double rms_mm = 0.0;     // what the homography leaves of the corners
  cv::Rect2d area_mm;      // part of the plane that the camera sees, axis-parallel
};

// From the corners of a board that lies on the plane (`corners` in captured pixels). Lens distortion is taken
// away first, since a homography knows none.
Rectification RectifyFromBoard(const Camera& camera, const std::vector<cv::Point2f>& corners, cv::Size inner,
                               double square_mm);

// The captured image as seen from above: pixel (i, j) shows the plane at area_mm.tl() + (i, j) / px_per_mm.
cv::Mat WarpToPlane(const cv::Mat& image, const Camera& camera, const Rectification& rectification);

// Plane coordinates (mm) of a captured pixel.
Eigen::Vector2d PlaneFromPixel(const Camera& camera, const Rectification& rectification,
                               const Eigen::Vector2d& pixel);

// Captured pixel that shows a place of the plane.
Eigen::Vector2d PixelFromPlane(const Camera& camera, const Rectification& rectification,
                               const Eigen::Vector2d& mm);

}  // namespace dorsum
