// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/json.h"
#include "base/result.h"
#include "stripes/pooling.h"
#include "stripes/ridge.h"

namespace dorsum {

struct FindStripesRequest {
  std::vector<std::filesystem::path> images;  // 8-bit colour; stripes are read in the green channel
  std::filesystem::path out_csv;
  bool pool = true;  // along the stripe; otherwise each row stands by itself
  RidgeOptions ridges;
  PoolingOptions pooling;
};

// What was found in one image.
struct FoundStripes {
  std::string image;
  std::size_t points = 0, segments = 0;
  double median_width_px = 0.0, median_sd_px = 0.0;  // 0 when there are no points
};

// The job behind `dorsum stripes`: writes one line per stripe and image row (row, column, sd, peak, width in
// px and grey values, segment counted from 0 in each image), led by the image's name where there are several
// images. Nothing is written when one of the images is no good.
Result<std::vector<FoundStripes>> FindStripes(const FindStripesRequest& request, const Context& context);

Json FoundStripesToJson(const std::vector<FoundStripes>& found);
std::string FoundStripesToText(const std::vector<FoundStripes>& found);

}  // namespace dorsum
