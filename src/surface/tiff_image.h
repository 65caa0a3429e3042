// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <opencv2/core.hpp>

namespace dorsum {

// TIFF 6.0 of one channel of 32-bit floats, compressed without loss. The same picture gives the same bytes.
std::string EncodeTiff(const cv::Mat1f& image);

}  // namespace dorsum
