// SPDX-License-Identifier: Apache-2.0
#include "speed/scene.h"

#include <cmath>
#include <cstdio>

#include "accuracy/rendered_device.h"
#include "base/files.h"
#include "jobs/calibrate.h"

namespace dorsum::speed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHand = "hand:woman:right:speed";

// The default device with pictures and lasers of another number.
std::string Describe(const SpeedDevice& device) {
  const int columns = 4 * static_cast<int>(std::lround(std::sqrt(device.megapixels * 1e6 / 12.0)));
  char text[256];
  std::snprintf(text, sizeof text, "[camera]\nresolution_px = [%d, %d]\nfocal_length_px = %.3f\n", columns,
                columns * 3 / 4, 2080.0 * columns / 1600.0);
  std::string out = text;
  for (int k = 0; k < device.lasers; ++k) {
    // Stripes of one laser lie 14.9 mm apart; up to four share that by quarters, more by eighths.
    const double apart = device.lasers <= 4 ? 11.15 : 9.3;
    std::snprintf(text, sizeof text, "[[laser]]\nposition_mm = [%.2f, 0.0, 395.0]\nchannel = %d\n",
                  apart * (k - 0.5 * (device.lasers - 1)), k);
    out += text;
  }
  for (const char* at : {"-430.0, 330.0", "440.0, 310.0", "0.0, -520.0"}) {
    out += std::string("[[led]]\nposition_mm = [") + at + ", 940.0]\n";
  }
  return out;
}

Result<ReadyCalibration> Calibrated(const fs::path& series, const fs::path& path, const std::string& method,
                                    const Context& context) {
  if (!fs::exists(path)) {
    CalibrateOptions options;
    options.method = method;
    DORSUM_RETURN_IF_ERROR(CalibrateFolder(series, path, options, context));
  }
  DORSUM_ASSIGN_OR_RETURN(Calibration calibration, ReadCalibration(path));
  return PrepareCalibration(std::move(calibration), path.string());
}

}  // namespace

Result<SpeedScene> MakeSpeedScene(const SpeedDevice& device, const fs::path& cache, const Context& context) {
  char name[64];
  std::snprintf(name, sizeof name, "speed-%.1f-megapixels-%d-lasers", device.megapixels, device.lasers);
  const fs::path toml = cache / (std::string(name) + ".toml");
  std::error_code ignored;
  fs::create_directories(cache, ignored);
  DORSUM_RETURN_IF_ERROR(WriteFile(toml, Describe(device)));
  DORSUM_ASSIGN_OR_RETURN(const accuracy::DeviceData data,
                          accuracy::RenderDevice(name, toml, "1", {kHand}, cache, context));
  SpeedScene scene;
  scene.calibration_dir = data.calibration_dir;
  scene.capture_dir = data.captures.front().capture_dir;
  scene.truth_dir = data.captures.front().truth_dir;
  scene.calibration_path = data.out_dir / "calibration_bundle.json";
  fs::create_directories(data.out_dir, ignored);
  DORSUM_ASSIGN_OR_RETURN(scene.bundle,
                          Calibrated(data.calibration_dir, scene.calibration_path, "bundle", context));
  DORSUM_ASSIGN_OR_RETURN(
      scene.classic,
      Calibrated(data.calibration_dir, data.out_dir / "calibration_classic.json", "classic", context));
  std::vector<int> lasers;
  for (int k = 0; k < device.lasers; ++k) lasers.push_back(k);
  DORSUM_ASSIGN_OR_RETURN(scene.capture, LoadCapture(scene.capture_dir, {}, lasers));
  scene.images = {scene.capture.hand};
  for (const auto& stripes : scene.capture.stripes) scene.images.push_back(*stripes);
  return scene;
}

}  // namespace dorsum::speed
