// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "captures/capture.h"
#include "jobs/reconstruct.h"

namespace dorsum::speed {

// A virtual device's capture of a hand in memory, with its calibrations.
struct SpeedScene {
  std::filesystem::path calibration_dir, capture_dir, truth_dir, calibration_path;
  CaptureImages capture;
  std::vector<cv::Mat> images;  // bgHand and all stripes of it
  ReadyCalibration bundle, classic;
};

struct SpeedDevice {
  double megapixels = 1.92;  // of 4:3 pictures
  int lasers = 4;            // 1 to 8
};

// Rendered and calibrated below `cache`, unless an earlier run did.
Result<SpeedScene> MakeSpeedScene(const SpeedDevice& device, const std::filesystem::path& cache,
                                  const Context& context);

}  // namespace dorsum::speed
