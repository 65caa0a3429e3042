// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "captures/device_description.h"
#include "captures/setup.h"

namespace dorsum {

// One picture of a calibration series (§3.2, DESIGN §4).
struct SeriesPicture {
  enum class Light { kDark, kLeds, kLaser };
  std::string name;  // relative to the calibration folder, without extension: "heights/h10.0/bgHand"
  Light light = Light::kLeds;
  int laser = -1;  // of kLaser
};

// What lies before the camera, and the pictures that are taken of it.
struct SeriesStep {
  enum class Thing {
    kBoard,             // the chessboard; number 0 flat on the backplane, the others raised and tilted
    kBackplane,         // nothing
    kBoardOnBackplane,  // the chessboard, its middle on the central stripe of laser `number`
    kLines,             // the sheet with a line for each laser
    kObject,            // the calibration object, wider than the picture
    kBoardOnObject,     // the chessboard on it, its middle on the central stripe of laser `number`
    kBox,               // a box of height_mm
  };
  Thing thing = Thing::kBackplane;
  int number = 0;
  double height_mm = 0.0;  // of the object or the box
  std::vector<SeriesPicture> pictures = {};
};

// The whole series in an order that asks for little moving about: chessboards, backplane, calibration object,
// boxes.
std::vector<SeriesStep> PlanCalibrationSeries(const DeviceDescription& device);

// What to do for a step, as a sentence to the person at the device.
std::string InstructionOf(const SeriesStep& step, const DeviceDescription& device);

// What setup.json of the device's series says.
Setup SetupOf(const DeviceDescription& device);

}  // namespace dorsum
