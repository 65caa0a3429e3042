// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "stripes/stripes.h"

namespace dorsum {

struct ClassicSegmentOptions {
  int min_area_px = 24;  // smaller regions are "probably not a stripe" (Algorithm 1), px
  int min_rows = 8;      // shortest stripe, px
};

// First half of Algorithm 1 (§3.5): flood-fills each region of the stripe mask, in the order in which a
// search column by column meets them, throws small ones away and takes the region's left boundary, row by
// row, as the stripe. `mask` is CV_8UC1, `green` the image's green channel of the same size.
LaserStripes ExtractClassicSegments(const cv::Mat& mask, const cv::Mat& green, int laser,
                                    const ClassicSegmentOptions& options);

}  // namespace dorsum
