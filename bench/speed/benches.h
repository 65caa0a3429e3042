// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "speed/figures.h"
#include "speed/scene.h"

namespace dorsum::speed {

// Everything that is timed inside this process, with Google Benchmark: medians of interleaved repetitions.
// `sizes`: scenes of other pictures and numbers of lasers, by the name that their times get.
Measured RunBenches(const SpeedScene& scene, const std::map<std::string, const SpeedScene*>& sizes);

// The points of Steger's detector and of ours beside the true stripes of the scene, by "points/" and what
// DetectorComparison::Summary() names.
Result<Measured> CompareDetectors(const SpeedScene& scene);

// Image-sized allocations of a scan after others of its kind.
Measured CountAllocations(const SpeedScene& scene);

// Calibration of the scene's series, and finding the corners of its boards alone.
Result<Measured> TimeCalibration(const SpeedScene& scene);

// Processes of `dorsum` (at `program`): one reconstruction against one that only reads its images (at
// `imread`), and a batch of `captures` against a process for each. Writes below `work`.
Result<Measured> TimeProcesses(const SpeedScene& scene, const std::filesystem::path& program,
                               const std::filesystem::path& imread, int captures,
                               const std::filesystem::path& work);

}  // namespace dorsum::speed
