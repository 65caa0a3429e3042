// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "imaging/cell_picture.h"

namespace dorsum {

// Closed curves of sub-pixel points, px; the last point joins the first. Holes are curves of their own. Along
// the image's border they run half a pixel outside of its outer pixels' centres.
using Outlines = std::vector<std::vector<cv::Point2f>>;

// The outlines of an object whose pixels are known (`mask`, CV_8UC1), to a part of a pixel: each place goes
// to the steepest change of `light` (imaging/led_ratio.h, scale 1) along the outline's normal within 2 px, as
// far as it is steeper than `texture` (> 0) says of the rest, and follows its neighbours along the outline
// otherwise.
Outlines FindOutlines(const cv::Mat& mask, const cv::Mat& light, const CellPicture& texture,
                      const Context& context = {});

// CV_8UC1, 255 on pixels whose centres lie within an odd number of the curves.
cv::Mat FillOutlines(const Outlines& outlines, cv::Size size, const Context& context = {});

}  // namespace dorsum
