// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dorsum {

// A camera of this machine, as Linux lists it.
struct CameraEntry {
  std::string device;   // "/dev/video0"
  std::string name;     // as its maker calls it; empty where the system does not say
  bool usable = false;  // may be opened, and gives pictures
  std::string problem;  // otherwise why not and what to do: "cannot be opened: permission denied; …"
};

// Every /dev/videoN in the order of its number. Those that exist only beside a camera, for its metadata, are
// left out. Opens each for a moment; one that another program films with is usable as far as can be seen.
std::vector<CameraEntry> ListCameras();

// The same in a tree of folders of other roots, where there are no devices to ask (for tests).
std::vector<CameraEntry> ListCameras(const std::filesystem::path& dev,
                                     const std::filesystem::path& sys_class);

}  // namespace dorsum
