// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "accuracy/capture_truth.h"
#include "base/result.h"

namespace dorsum::accuracy {

// A table of true stripes with the columns order, v, u, z, material and irradiance, named in its first line
// and in any order; plain or gzipped.
Result<std::vector<TrueStripe>> ReadStripeTable(const std::filesystem::path& path);

}  // namespace dorsum::accuracy
