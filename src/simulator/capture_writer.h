// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/context.h"
#include "simulator/renderer.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// The pictures of a capture (§3.3): bgHand and stripesHandK of every laser. `noise_seed` names this moment:
// another one gives the same scene with other noise.
Status WriteCapturePictures(const VirtualDevice& device, const Stage& stage, std::uint64_t noise_seed,
                            const std::filesystem::path& dir, const Context& context);

// The same of a scene, and its ground truth into `truth_dir` unless that is empty.
Status WriteCapture(const VirtualDevice& device, Scene scene, std::uint64_t noise_seed,
                    const std::filesystem::path& capture_dir, const std::filesystem::path& truth_dir,
                    const Context& context);

// Makes a folder with its parents.
Status MakeFolder(const std::filesystem::path& dir);

}  // namespace dorsum
