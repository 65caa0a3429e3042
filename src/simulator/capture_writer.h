// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/context.h"
#include "simulator/disturbance.h"
#include "simulator/renderer.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// What a capture has beyond the usual.
struct CaptureExtras {
  std::optional<Motion> motion;  // of the object, within the capture
  bool after = false;            // also bgHandAfter
};

// The pictures of a scene (§3.3) into `capture_dir`: bgHand and stripesHandK of every laser. `noise_seed`
// names this moment: another one gives the same scene with other noise. And the ground truth into `truth_dir`
// unless that is empty: of an object that moves, the stripes of each laser are where that laser saw them;
// height, material and reference show its first place.
Status WriteCapture(const VirtualDevice& device, Scene scene, const CaptureExtras& extras,
                    std::uint64_t noise_seed, const std::filesystem::path& capture_dir,
                    const std::filesystem::path& truth_dir, const Context& context);

// Makes a folder with its parents.
Status MakeFolder(const std::filesystem::path& dir);

}  // namespace dorsum
