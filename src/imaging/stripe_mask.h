// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

struct StripeMaskOptions {
  int block_px = 61;  // side of the adaptive threshold's window, px, 3 to 999; wider than a stripe, narrower
                      // than their spacing; an even side grows by one
  double offset = 5.0;  // how far the edge response must exceed its local mean, grey values, 0 to 255
  int median_px = 3;    // side of the median's window, px, 1 to 15; an even side grows by one
};

// The document's stripe masking (§3.4, Figure 3.5): vertical edges by the kernel of equation 3.5, the G
// channel, adaptive threshold, median blur. The kernel answers where brightness falls towards growing u, so
// each stripe gives one region that begins at the stripe's middle and covers its falling flank. `image` is
// CV_8UC3, `region` CV_8UC1 (only its non-zero pixels are looked at) or empty. Returns CV_8UC1, 0 or 255.
cv::Mat ExtractStripeMask(const cv::Mat& image, const cv::Mat& region, const StripeMaskOptions& options,
                          const std::string& sink_key, const Context& context = {});

}  // namespace dorsum
