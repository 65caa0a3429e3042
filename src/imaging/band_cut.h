// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "imaging/cell_picture.h"

namespace dorsum {

// A picture to be parted in two where that is still open. All of one size.
struct BandCut {
  cv::Mat known;  // CV_8UC1: kBackplanePixel, kObjectPixel or kUnknownPixel (imaging/seed_map.h)
  cv::Mat pull;   // CV_32FC1: what it costs to call the pixel backplane (> 0) or object (< 0), px of outline;
                  // only that of unknown pixels counts
  cv::Mat light;  // CV_32FC1: the picture
  CellPicture texture;  // > 0: difference between neighbours that still is no edge
};

// Names the unknown pixels object or backplane by the cheapest cut: an outline's piece costs its length, px,
// over 1 + (step of light across / texture)^2. A step is the difference between neighbours less the slope
// that it sits on, which is what the soft edge of a shadow consists of. Neighbourhood of 8 with the weights
// that measure Euclidean length (Boykov and Kolmogorov 2003). Returns CV_8UC1, 255 on the object.
cv::Mat CutInBand(const BandCut& input, const Context& context = {});

}  // namespace dorsum
