// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "captures/capture.h"
#include "captures/device_description.h"
#include "device/device.h"
#include "jobs/reconstruct.h"

namespace dorsum {

struct CaptureRequest {
  std::filesystem::path out_dir;  // the capture folder; must not exist or be empty
  std::filesystem::path
      calibration_path;     // optional: lets the session tell hand from backplane and lasers apart
  std::vector<int> lasers;  // empty: all of the device
  int average = 1;          // frames averaged per picture, 1 to 64
  int retries = 2;          // of what can be retried, 0 to 10
};

struct CaptureSummary {
  std::vector<std::string> files;     // written, relative to out_dir
  std::vector<std::string> warnings;  // one sentence each
  int retried = 0;                    // pictures that had to be taken again
};

// A capture that is whole, not written yet.
struct TakenCapture {
  CaptureImages images;  // with warnings
  int retried = 0;
};

// One capture (§3.3) with a device: bgHand under the LEDs, stripesHandK under each laser alone, bgHandAfter.
// Checks each picture while it goes (jobs/capture_checks.h), against the calibration too where there is one,
// and takes again what can be. The lights are off afterwards, whatever happened. `request.out_dir` and
// `request.calibration_path` are not looked at.
Result<TakenCapture> TakeCapture(Device& device, const CaptureRequest& request,
                                 const ReadyCalibration* calibration, const Context& context);

// Writes a capture folder, all of it or nothing; the names of its files. It must not exist or be empty.
Result<std::vector<std::string>> SaveCapture(const CameraDesign& camera, const CaptureImages& capture,
                                             const std::filesystem::path& out_dir);

// Both: the job behind `dorsum capture`.
Result<CaptureSummary> CaptureToFolder(Device& device, const CaptureRequest& request, const Context& context);

}  // namespace dorsum
