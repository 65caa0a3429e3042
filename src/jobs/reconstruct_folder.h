// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jobs/reconstruct_outputs.h"

namespace dorsum {

Result<LoadedCalibration> LoadCalibration(const std::filesystem::path& path);

// What a reconstruction needs of the pictures of stripes: green alone, unless it shows them or looks at their
// colours.
Channels StripeChannels(const ReconstructRequest& request);

// Reconstructs images that are in memory and writes the outputs to request.out_dir, all or nothing.
Result<ReconstructSummary> ReconstructLoaded(const CaptureImages& capture, const ReconstructRequest& request,
                                             const LoadedCalibration& calibration, const Context& context);

}  // namespace dorsum
