// SPDX-License-Identifier: Apache-2.0
#include "device/video_capture.h"

#include <filesystem>

#include <dlfcn.h>

#include "device/device_error.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// Beside the program as in a build, in the library folder beside it as installed, or where that was put.
std::vector<fs::path> Places() {
  std::error_code ec;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec).parent_path();
  return {program / kVideoModule, program.parent_path() / DORSUM_LIBRARY_FOLDER / "dorsum" / kVideoModule,
          fs::path(DORSUM_FULL_LIBRARY_FOLDER) / "dorsum" / kVideoModule};
}

// Stays loaded for as long as the program runs.
void* LoadModule() {
  std::error_code ec;
  for (const fs::path& place : Places()) {
    if (!fs::exists(place, ec)) continue;
    if (void* module = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
  }
  return nullptr;
}

}  // namespace

Result<std::unique_ptr<VideoCapture>> MakeVideoCapture() {
  static void* const module = LoadModule();
  auto* const make = module == nullptr
                         ? nullptr
                         : reinterpret_cast<MakeVideoCaptureFunction>(dlsym(module, kMakeVideoCapture));
  if (make == nullptr) {
    return DeviceError(std::string("cameras need ") + kVideoModule +
                       ", which is missing or cannot be loaded; install Dorsum again, with OpenCV's videoio");
  }
  return std::unique_ptr<VideoCapture>(make());
}

}  // namespace dorsum
