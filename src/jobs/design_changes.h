// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "captures/device_description.h"

namespace dorsum {

// What a person wants other than a device description has it. Ranges are the description's own.
struct DesignChanges {
  std::optional<double> lines_per_mm, wavelength_nm, turn_deg;
  std::optional<int> orders;
  std::optional<double> slit_um;  // brightness of the orders by equation 2.2, above 0 to the grating's period
  std::optional<int> lasers;      // 1 to 8, all like the first
  std::optional<double> pitch_mm;  // between neighbouring lasers, 0.1 to 500
  std::optional<double> laser_height_mm, camera_height_mm;
  std::optional<double> baseline_mm;  // camera to the middle of the lasers, across the stripes; on the side
                                      // on which the camera is
  std::optional<double> focal_length_px;
  std::vector<int> resolution_px;  // width, height; empty: as it is
  std::vector<double> heights_mm;  // of the working volume, lowest and highest; empty: as it is
};

// The description with the changes, checked as if it had been read from a file. Where the grating's orders
// were not asked for, there are as many as leave the grating.
Result<DeviceDescription> ApplyChanges(DeviceDescription description, const DesignChanges& changes);

// Sets the brightness of the orders to the envelope of slits of this width (2.2), within what a description
// takes.
void SetSlit(double slit_um, GratingDesign* grating);

// Puts `count` lasers like the first `pitch_mm` apart around x = `middle_mm`.
void PlaceLasers(int count, double pitch_mm, double middle_mm, std::vector<LaserDesign>* lasers);

// Mean x of the lasers.
double MiddleOfLasers(const DeviceDescription& description);

// The most orders, up to 60, that leave a grating well (orders * step at most 0.95, as descriptions ask); 0
// where not even the first does.
int MostOrders(const GratingDesign& grating);

}  // namespace dorsum
