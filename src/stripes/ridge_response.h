// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "stripes/ridge_kernel.h"

namespace dorsum {

// How strongly one row of a picture answers to a stripe's profile, with room that is used again from row to
// row. All of it is in integers of 1/64 of a grey value.
class RidgeResponse {
 public:
  static constexpr float kUnit = 1.0F / RidgeKernel::kRowUnit;

  explicit RidgeResponse(RidgeKernel kernel);

  // Of the columns [first, end), at least one, in a row of a CV_8UC1 picture; rows and columns beyond its
  // borders are as the last ones within.
  void Compute(const cv::Mat& green, int row, int first, int end);

  const RidgeKernel& kernel() const { return kernel_; }
  // Of the columns from the first on.
  const std::vector<std::int16_t>& response() const { return response_; }
  // The rows' kernel alone, at a place of the response.
  std::int16_t Smoothed(std::size_t place) const { return padded_[place + pad_]; }

  // Places in the response, none at its ends, where it is at least `least`, more than to the left and no less
  // than to the right.
  const std::vector<int>& Peaks(std::int16_t least);

 private:
  RidgeKernel kernel_;
  std::size_t pad_;
  std::vector<const std::uint8_t*> rows_;
  std::vector<std::int16_t> padded_, response_;
  std::vector<int> peaks_;
};

}  // namespace dorsum
