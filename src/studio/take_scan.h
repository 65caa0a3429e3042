// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "device/device.h"
#include "studio/finger_quality.h"
#include "studio/workbench.h"

namespace dorsum {

// A scan as it came from the device, kept nowhere yet.
struct TakenScan {
  std::shared_ptr<const Scan> scan;
  std::vector<FingerQuality> fingers;
  double last_frame_s = 0.0;  // when its last picture was there, of MonotonicSeconds()
};

// The last stage that TakeScan() reports; before it come the pictures, by their names in a capture folder.
inline constexpr const char* kSurfaceStage = "surface";
std::vector<std::string> StagesOfScan(int lasers);

// Captures what lies before the device, and computes its surface and how good its fingers are.
Result<TakenScan> TakeScan(Device& device, const std::shared_ptr<const ReadyCalibration>& calibration,
                           const std::string& name, const Context& context);

}  // namespace dorsum
