// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace dorsum {

// Decodes a PNG of 8 bits per channel: a coloured one to BGR (CV_8UC3), a grey one to CV_8UC1, without alpha.
// Values stay as they are in the file, whatever it says of gamma. An empty picture where the file is damaged,
// deeper than 8 bits or more than 100 megapixels large. Writes nothing to the standard error.
cv::Mat DecodePng(std::string_view bytes);

// PNG of a picture with 1 or 3 channels (grey or BGR) of 8 or 16 bits. `compression`: 0 (none) to 9 (best);
// 1 is quick and meant for masks, which are even over large parts. The same picture gives the same bytes.
std::string EncodePng(const cv::Mat& image, int compression = 3);

}  // namespace dorsum
