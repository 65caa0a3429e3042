// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <opencv2/core.hpp>

#include "base/result.h"
#include "captures/device_description.h"

namespace dorsum {

// Writes an 8-bit BGR picture in the format that the device's camera is to deliver: `stem` gets its
// extension. Aside and renamed; an error where that cannot be written.
Status WritePictureFile(const CameraDesign& camera, const cv::Mat& bgr, const std::filesystem::path& stem);

// What becomes of a picture in the JPEG stream of a webcam (camera.stream_jpeg_quality): for the simulator.
Result<cv::Mat> ThroughStream(const CameraDesign& camera, const cv::Mat& bgr);

}  // namespace dorsum
