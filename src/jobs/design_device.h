// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "base/result.h"
#include "captures/device_description.h"
#include "geometry/camera.h"
#include "geometry/diffraction.h"
#include "geometry/light_sheet.h"

namespace dorsum {

// One laser as designed, in the frame of the design.
struct DesignedLaser {
  DiffractedFan fan;
  std::vector<double>
      efficiency;            // of orders 0, 1, ... (the same on both sides), relative to the central one
  double sigma_alpha = 0.0;  // half width of a stripe in direction cosine, one standard deviation
  double half_angle = 0.0;   // of the fan, rad
  double power = 0.0;        // irradiance at distance r straight ahead is power / (r (r + s))

  int Orders() const { return static_cast<int>(efficiency.size()) - 1; }
};

// A device exactly as it is described: the virtual device of the simulator without what mounting gets wrong
// and without what differs from part to part.
struct DesignedDevice {
  DeviceDescription description;
  Camera camera;
  std::vector<DesignedLaser> lasers;
  Eigen::AlignedBox2d hand;  // the area on which the hand lies, mm
};

// Lays the device out and puts a hand area of this size (along x and y, mm) in the middle of what the camera
// sees of all of the working volume. An error where the camera does not see the backplane, or stands below
// the volume's top.
Result<DesignedDevice> LayOutDevice(const DeviceDescription& description, const Eigen::Vector2d& hand_mm);

// What the camera sees at height z: the largest rectangle between the picture's four corners. An empty box
// where a corner looks past the plane.
Eigen::AlignedBox2d SeenRectangle(const Camera& camera, double z);

// The chessboard's largest square, at most the described one and in whole mm where that is more than one,
// with which the board fits into four fifths of the picture on the calibration object.
double FittingSquare(const DesignedDevice& device);

// Brightness of order m over that of the central one, as the description has it: like a Gaussian from the
// first order to the last.
double DescribedEfficiency(const GratingDesign& grating, int order);

SlitGrating GratingOf(const GratingDesign& grating);

}  // namespace dorsum
