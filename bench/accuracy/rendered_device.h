// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"

namespace dorsum::accuracy {

// A device whose calibration series and captures lie on disk, with the truth.
struct DeviceData {
  std::string design, seed;
  std::filesystem::path calibration_dir, device_json;
  struct Capture {
    std::string name;
    std::filesystem::path capture_dir, truth_dir;
  };
  std::vector<Capture> captures;
  std::filesystem::path out_dir;  // for what is made of them
};

// A name without what folders should not have in theirs.
std::string FolderName(std::string text);

// Renders a virtual device below `cache`, or finds what an earlier run rendered there: the folder's name
// holds a hash of the device description, the seed and the simulator's sources. Scenes are kept one by one,
// so that another scene does not render all again.
Result<DeviceData> RenderDevice(const std::string& design, const std::filesystem::path& device_toml,
                                const std::string& seed, const std::vector<std::string>& scenes,
                                const std::filesystem::path& cache, const Context& context);

// A folder of rendered captures: calibration/, captures/NAME/, truth/NAME/, truth/device.json.
Result<DeviceData> FindCaptures(const std::filesystem::path& dir, const std::filesystem::path& out_dir);

}  // namespace dorsum::accuracy
