// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "geometry/camera.h"
#include "report/colours.h"

namespace dorsum {

// What the drawings of a device need to know of it, in the frame of the design, mm.
struct DesignDrawing {
  struct Stripe {
    int laser = 0, order = 0;
    std::vector<Eigen::Vector3d> points;  // along it, on the backplane
  };
  Camera camera;
  std::vector<Eigen::Vector3d> gratings;  // by laser
  std::vector<Stripe> stripes;
  Eigen::AlignedBox2d hand;
  double low_mm = 0.0, high_mm = 80.0;  // the working volume
};

// Seen along y: camera with its field of view, gratings with the middles of their light sheets in the orders'
// colours, the backplane and the working volume over the hand area.
cv::Mat DrawDesignFromTheSide(const DesignDrawing& drawing, cv::Size size = {960, 720});

// The empty backplane as the camera sees it: the first laser's stripes in the orders' colours, those of the
// others dimmer, and the hand area at the bottom and the top of the volume.
cv::Mat DrawDesignAsSeen(const DesignDrawing& drawing, int width = 960);

// A quantity along the backplane's x, one line for each laser or height. Gaps where a value is not finite.
struct DesignCurve {
  std::string name;
  std::vector<Eigen::Vector2d> points;
};
cv::Mat DrawDesignCurves(const std::vector<DesignCurve>& curves, const std::string& x_name,
                         const std::string& y_name, cv::Size size = {960, 720});

}  // namespace dorsum
