// SPDX-License-Identifier: Apache-2.0
#include "accuracy/rendered_device.h"

#include <algorithm>
#include <cctype>

#include "base/files.h"
#include "base/version.h"
#include "simulator/named_scene.h"
#include "simulator/simulate.h"

namespace dorsum::accuracy {
namespace {

namespace fs = std::filesystem;

// The version's number stays while the simulator changes, so its sources stand for it.
Result<std::string> SimulatorVersion() {
  const fs::path src = fs::path(DORSUM_SOURCE_DIR) / "src";
  std::vector<fs::path> files = {src / "geometry/camera.cc", src / "geometry/light_sheet.cc",
                                 src / "captures/device_description.cc"};
  for (const auto& entry : fs::directory_iterator(src / "simulator")) {
    const std::string name = entry.path().filename().string();
    const bool code = name.ends_with(".cc") || name.ends_with(".h");
    if (code && name.find("_test.") == std::string::npos) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::string all = kVersion;
  for (const fs::path& file : files) {
    DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadFile(file));
    all += text;
  }
  return Sha256Hex(all);
}

// Runs the simulator unless the folder is there: it appears whole or not at all.
Status SimulateOnce(const SimulateOptions& options, const fs::path& dir, const Context& context) {
  if (fs::exists(dir)) return {};
  const Result<SimulateReport> report = Simulate(options, dir, context);
  return report.ok() ? Status() : Status(report.error());
}

}  // namespace

std::string FolderName(std::string text) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '-'; };
  std::replace_if(
      text.begin(), text.end(), [&](char c) { return !plain(static_cast<unsigned char>(c)); }, '-');
  return text;
}

Result<DeviceData> RenderDevice(const std::string& design, const fs::path& device_toml,
                                const std::string& seed, const std::vector<std::string>& scenes,
                                const fs::path& cache, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const std::string description, ReadFile(device_toml));
  DORSUM_ASSIGN_OR_RETURN(const std::string simulator, SimulatorVersion());
  const std::string key = Sha256Hex(description + '\n' + seed + '\n' + simulator).substr(0, 12);
  const fs::path root = cache / FolderName(design + " " + seed + " " + key);
  SimulateOptions options;
  options.device_path = device_toml;
  options.seed = seed;
  DORSUM_RETURN_IF_ERROR(SimulateOnce(options, root / "device", context));
  DeviceData data{design, seed,        root / "device/calibration", root / "device/truth/device.json",
                  {},     root / "out"};
  options.calibration = false;
  for (const std::string& scene : scenes) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    DORSUM_ASSIGN_OR_RETURN(const SceneName name, ParseSceneName(scene));
    const fs::path dir = root / "scenes" / name.folder;
    options.scenes = {scene};
    DORSUM_RETURN_IF_ERROR(SimulateOnce(options, dir, context));
    data.captures.push_back({name.folder, dir / "captures" / name.folder, dir / "truth" / name.folder});
  }
  return data;
}

Result<DeviceData> FindCaptures(const fs::path& dir, const fs::path& out_dir) {
  DeviceData data{fs::absolute(dir).lexically_normal().filename().string(),
                  "",
                  dir / "calibration",
                  dir / "truth/device.json",
                  {},
                  out_dir};
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(dir / "captures", error)) {
    const std::string name = entry.path().filename().string();
    if (fs::is_directory(dir / "truth" / name))
      data.captures.push_back({name, entry.path(), dir / "truth" / name});
  }
  if (data.captures.empty()) return BadInput(dir.string() + " holds no captures with truth");
  std::sort(data.captures.begin(), data.captures.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return data;
}

}  // namespace dorsum::accuracy
