// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "base/result.h"
#include "surface/height_field.h"

namespace dorsum {

// height.tiff (float32, NaN where nothing was seen, row 0 at the smallest y) and height.json beside it with
// origin, pitch and frame (DESIGN §4). Nothing is written for an empty field.
Status WriteHeightField(const std::filesystem::path& folder, const HeightField& field);

}  // namespace dorsum
