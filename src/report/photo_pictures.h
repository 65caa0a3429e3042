// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "stripes/stripes.h"

namespace dorsum {

struct PhotoPictureOptions {
  int width_px = 1200;    // of the picture; a smaller photo is enlarged, 64 to 4000
  double text_px = 16.0;  // height of order numbers, 5 to 100
};

// A photo as a person wants to see it: photos under one colour of light are dark and all green, so this is
// the brightest channel in grey, stretched between its 0.5 and 99.5 percent points. CV_8UC3 of the same size.
cv::Mat BrightenPhoto(const cv::Mat& photo);

// The object's mask (CV_8UC1, the photo's size) over the brightened photo: tinted inside, outlined, and
// dimmer outside. An empty mask leaves the photo as it is.
cv::Mat DrawMask(const cv::Mat& photo, const cv::Mat& mask, const PhotoPictureOptions& options = {});

// Stripes over the dimmed photo, coloured by order, with order numbers beside longer segments, as Figure 5.2
// of the document. Segments without an order are grey.
cv::Mat DrawIndexedStripes(const cv::Mat& photo, const LaserStripes& stripes,
                           const PhotoPictureOptions& options = {});

}  // namespace dorsum
