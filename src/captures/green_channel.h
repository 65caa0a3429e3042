// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

// The green channel of a BGR picture (CV_8UC3), in which the stripes are read (§3.4), as CV_8UC1; a picture
// of one channel (CV_8UC1) is it already, and shares its pixels.
cv::Mat GreenChannel(const cv::Mat& picture);
cv::Mat GreenChannel(const cv::Mat& picture, const Context& context);  // on its threads

// The green of `count` pixels that lie as B, G, R one behind the other.
void TakeGreen(const std::uint8_t* bgr, std::size_t count, std::uint8_t* green);

}  // namespace dorsum
