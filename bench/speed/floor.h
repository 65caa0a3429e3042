// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum::speed {

// The sum of all bytes of some images, in one pass of one thread: no program that looks at every pixel is
// faster, so its time is the unit of all others.
std::uint64_t SumBytes(const std::vector<cv::Mat>& images);

}  // namespace dorsum::speed
