// SPDX-License-Identifier: Apache-2.0
#include "speed/floor.h"

#include <cstddef>

namespace dorsum::speed {

std::uint64_t SumBytes(const std::vector<cv::Mat>& images) {
  std::uint64_t sum = 0;
  for (const cv::Mat& image : images) {
    for (int row = 0; row < image.rows; ++row) {
      const std::uint8_t* bytes = image.ptr(row);
      const std::size_t count = static_cast<std::size_t>(image.cols) * image.elemSize();
      std::uint32_t line = 0;  // holds 16 million bytes of 255
      for (std::size_t i = 0; i < count; ++i) line += bytes[i];
      sum += line;
    }
  }
  return sum;
}

}  // namespace dorsum::speed
