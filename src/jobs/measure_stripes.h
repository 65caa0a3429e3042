// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "jobs/reconstruct_options.h"
#include "stripes/shading.h"
#include "stripes/stripes.h"

namespace dorsum {

// Takes away the stripe points outside the mask (CV_8UC1, not 0 on the object). Even a pixel further out a
// stripe of the backplane that the outline cuts would bend the surface down.
void KeepInside(const cv::Mat& mask, IndexedStripes* stripes);

// From single rows to what is known of the sheets' centres, once the object and the orders are: the surface's
// shading is taken off (stripes/shading.h) and rows are pooled (stripes/pooling.h). `green_hand`: of the
// hand's picture, CV_8UC1; `pictures`: by laser. `options` are resolved; the stripes must be ridges.
void MeasureStripes(const cv::Mat& green_hand, const cv::Mat& mask,
                    const std::map<int, LaserPicture>& pictures, const ReconstructOptions& options,
                    const Context& context, IndexedStripes* stripes);

}  // namespace dorsum
