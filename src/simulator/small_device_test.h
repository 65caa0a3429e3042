// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "captures/device_description.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// The default device with a picture so small that a test renders it at once: the whole field at coarse
// pixels.
inline DeviceDescription CoarseDevice(int width = 320) {
  DeviceDescription d = DefaultDevice();
  const double scale = static_cast<double>(width) / d.camera.width;
  d.camera.width = width;
  d.camera.height = width * 3 / 4;
  d.camera.focal_length_px *= scale;
  d.mounting.principal_point_px *= scale;
  d.camera.format = "png";
  return d;
}

// The middle of the default device's picture at its full sharpness.
inline DeviceDescription CroppedDevice(int width = 480, int height = 200) {
  DeviceDescription d = DefaultDevice();
  d.camera.width = width;
  d.camera.height = height;
  d.camera.format = "png";
  return d;
}

inline DeviceDescription WithoutNoise(DeviceDescription d) {
  d.sensor.full_well_e = 0.0;
  d.speckle.contrast = 0.0;
  d.light.ambient_laser = 0.0;
  return d;
}

}  // namespace dorsum
