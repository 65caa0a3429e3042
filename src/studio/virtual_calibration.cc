// SPDX-License-Identifier: Apache-2.0
#include "studio/virtual_calibration.h"

#include "base/files.h"
#include "base/version.h"
#include "device/virtual_bench.h"
#include "jobs/calibrate.h"
#include "jobs/live_series.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr double kSeriesShare = 0.7;  // of the whole time that the pictures take, roughly

Context Part(const Context& whole, double from, double to) {
  Context part = whole;
  part.progress = [&whole, from, to](std::string_view stage, double fraction) {
    whole.Report(stage, from + (to - from) * fraction);
  };
  return part;
}

}  // namespace

fs::path VirtualCalibrationDir(const fs::path& cache, const std::string& name) {
  std::string key = name + "\n" + kVersion + "\n";
  std::error_code ec;
  if (fs::is_regular_file(name, ec)) {
    if (const Result<std::string> text = ReadFile(name); text.ok()) key += *text;
  }
  return cache / "virtual-calibrations" / Sha256Hex(key).substr(0, 16);
}

Result<fs::path> CalibrateVirtualDevice(Device& device, const fs::path& dir, const Context& context) {
  if (!device.bench) return UsageError("only a virtual device calibrates by itself; use the calibrate page");
  const auto attendant = MakeVirtualAttendant(device.bench);
  LiveSeriesRequest request;
  request.dir = dir / "series";
  const Result<LiveSeriesSummary> series =
      TakeCalibrationSeries(device, *attendant, request, Part(context, 0.0, kSeriesShare));
  DORSUM_RETURN_IF_ERROR(device.bench->PlaceNamed("plane"));
  if (!series.ok()) return series.error();
  const fs::path file = dir / "calibration.json";
  const auto run = CalibrateFolder(request.dir, file, {}, Part(context, kSeriesShare, 1.0));
  if (!run.ok()) return run.error();
  return file;
}

}  // namespace dorsum
