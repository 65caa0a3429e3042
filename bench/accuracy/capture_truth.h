// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"
#include "geometry/camera.h"

namespace dorsum::accuracy {

// Where an image row meets the middle of a visible, lit stripe of the true scene.
struct TrueStripe {
  int order = 0, row = 0;
  double u = 0.0;  // px, sub-pixel, in the captured, distorted image
  double z = 0.0;  // mm
  int material = 0;
  double irradiance = 0.0;  // 1 brings a white surface to full scale
};

// What is true of one rendered capture: a truth folder of ours or of another renderer with the same layout
// (height.png, material.png, stripesK.csv or .csv.gz; device.json one level up).
struct CaptureTruth {
  Camera camera;
  cv::Mat3d xyz;                                  // world, mm, at each pixel's centre; NaN where nothing is
  cv::Mat1b material;                             // simulator/scene.h: Material
  std::map<int, std::vector<TrueStripe>> lasers;  // by row, then u

  // Board, brown, skin and grey are objects; the backplane is not.
  static bool IsObject(int material) { return material >= 1 && material <= 5; }
};

Result<CaptureTruth> ReadCaptureTruth(const std::filesystem::path& truth_dir,
                                      const std::filesystem::path& device_json);

// The true camera of a device.json.
Result<Camera> ReadTrueCamera(const std::filesystem::path& device_json);

// Bilinear truth at an image point, NaN unless its four neighbours are of one object's material and within
// `max_step_mm` of height.
cv::Vec3d TruthAt(const CaptureTruth& truth, double u, double v, double max_step_mm);

}  // namespace dorsum::accuracy
