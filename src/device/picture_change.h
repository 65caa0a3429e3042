// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

// What matters of a frame for whether the light has settled: the mean brightness of 32 x 32 tiles, in grey
// levels. A tile of a camera's picture holds a thousand pixels and more, so its noise is small, and a hand's
// tremor moves little light from one tile to the next.
struct PictureTiles {
  cv::Mat mean;       // CV_32F, 32 x 32 or smaller for a smaller picture
  cv::Mat grey;       // CV_32F: some of the picture's pixels, from which the noise is estimated
  double area = 1.0;  // pixels in a tile
};
PictureTiles TilesOf(const cv::Mat& bgr);

// How two frames of one size differ, band by band of tiles, since a rolling shutter changes rows in turn.
struct PictureChange {
  double worst_band = 0.0;     // mean difference of the band that differs most, grey levels
  double changed_bands = 0.0;  // share of the bands that differ by more than noise and flicker allow, 0 to 1
};
PictureChange ChangeBetween(const PictureTiles& a, const PictureTiles& b);

// No band differs.
bool Agree(const PictureChange& change);
// The light differs: one band alone may be somebody's finger.
bool ShowsOtherLight(const PictureChange& change);

}  // namespace dorsum
