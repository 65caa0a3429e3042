// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "accuracy/capture_truth.h"

namespace dorsum::accuracy {

// 1 where the camera sees the object or is at most `margin_px` columns and rows from where it does, else 0.
cv::Mat1b ObjectArea(const CaptureTruth& truth, int margin_px);

}  // namespace dorsum::accuracy
