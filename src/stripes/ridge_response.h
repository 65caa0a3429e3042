// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// How strongly one row of a picture answers to a stripe's profile, with room that is used again from row to
// row. The five rows around it are smoothed first, binomially.
class RidgeResponse {
 public:
  // Half of a symmetric kernel, from its middle outwards, at most 64 columns.
  explicit RidgeResponse(std::vector<float> kernel);

  // Of the columns [first, end), at least one, in a row of a CV_8UC1 picture; rows and columns beyond its
  // borders are as the last ones within.
  void Compute(const cv::Mat& green, int row, int first, int end);

  const std::vector<float>& kernel() const { return kernel_; }
  // Of the columns from the first on.
  const std::vector<float>& response() const { return response_; }
  // The five rows alone, at a place of the response.
  float Smoothed(std::size_t place) const { return padded_[place + pad_]; }

  // Places in the response, none at its ends, where it is at least `least`, more than to the left and no less
  // than to the right.
  const std::vector<int>& Peaks(float least);

 private:
  std::vector<float> kernel_;
  std::size_t pad_;
  std::vector<float> padded_, response_;
  std::vector<int> peaks_;
};

// Variance of the response to noise of variance 1 in every pixel.
double NoiseGain(const std::vector<float>& kernel);

}  // namespace dorsum
