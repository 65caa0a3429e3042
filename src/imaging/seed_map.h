// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "imaging/object_mask.h"

namespace dorsum {

inline constexpr std::uint8_t kBackplanePixel = 0, kObjectPixel = 1, kUnknownPixel = 2;

struct SeedMap {
  cv::Mat known;   // CV_8UC1: kBackplanePixel, kObjectPixel or kUnknownPixel
  cv::Mat votes;   // CV_32FC1: rows of stripes on the object less those on the backplane, in each pixel
  cv::Mat bridge;  // CV_8UC1, 255 where a bright ring may part the object: no darker than the object left and
                   // right of it, and a little wider than the stripes' distance
};

// The votes alone.
cv::Mat CountVotes(const std::vector<ObjectSeed>& seeds, cv::Size size, int scale);

// What the seeds say of the pixels of an image of `ratio`'s size, `scale` times smaller than the captured
// one. Between two seeds of one kind that follow each other in a row, all pixels are of that kind, when the
// seeds lie no further apart than most neighbours do and the light between them is even.
SeedMap MapSeeds(const std::vector<ObjectSeed>& seeds, const cv::Mat& ratio, int scale,
                 const Context& context = {});

}  // namespace dorsum
