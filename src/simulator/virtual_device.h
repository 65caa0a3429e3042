// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "captures/device_description.h"
#include "geometry/camera.h"
#include "geometry/light_sheet.h"

namespace dorsum {

// Dust on a grating: rays around one direction cosine along the fan are held back, of all orders alike.
struct DirtySpot {
  double beta = 0.0;          // its middle
  double half_width = 0.02;   // in beta, to where half of the loss is left
  double transmission = 0.1;  // in its middle
};

struct VirtualLaser {
  DiffractedFan fan;
  std::vector<double> efficiency;  // of orders -M .. M, the central one 1
  double sigma_alpha = 0.0;        // half width of a stripe in direction cosine, one standard deviation
  double half_angle = 0.0;         // rad
  double power = 0.0;              // see LaserIrradiance()
  double relative_power = 0.0;
  std::vector<DirtySpot> dirt;
  Eigen::Vector3d position_error_mm = Eigen::Vector3d::Zero();  // for the record: what mounting got wrong
  Eigen::Vector3d rotation_error_rad = Eigen::Vector3d::Zero();

  int Orders() const { return static_cast<int>(efficiency.size()) / 2; }
  double Efficiency(int order) const { return efficiency.at(static_cast<unsigned>(order + Orders())); }
};

// A round, evenly bright screen that faces the origin.
struct VirtualLed {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double radius_mm = 0.0;
  double intensity = 0.0;  // irradiance at distance d straight ahead is intensity / d^2
};

// A device as it truly is: the description with the mounting errors of one named seed, in the world frame of
// DESIGN §2. Nobody but the simulator and tests knows it.
struct VirtualDevice {
  DeviceDescription description;
  std::uint64_t seed = 0;  // of the device; images draw their noise below it
  Camera camera;
  std::vector<VirtualLaser> lasers;
  std::vector<VirtualLed> leds;
};

VirtualDevice BuildVirtualDevice(const DeviceDescription& description, std::uint64_t seed);

// Point of the laser's central stripe at height z whose y is given, and the stripe's unit direction there.
struct StripePointOnPlane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();
};
StripePointOnPlane CentralStripeAt(const DiffractedFan& fan, double z, double y);

// The laser whose central stripe fixes the world frame (DESIGN §2): number 1, or the lowest where there is
// none.
inline int WorldLaser(const VirtualDevice& device) { return device.lasers.size() > 1 ? 1 : 0; }

}  // namespace dorsum
