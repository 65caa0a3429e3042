// SPDX-License-Identifier: Apache-2.0
#include "imaging/led_ratio.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/core/hal/hal.hpp>

#include "base/parallel.h"
#include "captures/green_channel.h"

namespace dorsum {
namespace {

constexpr int kDarkest = 6;  // grey values; below it the ratio is noise
constexpr int kRows = 32;    // of the result that are found together

using Line = std::vector<std::uint16_t>;

// Sums over squares of a green channel that is one of them high; at the picture's end it may be cut off.
void SumSquares(const cv::Mat& green, int scale, Line* sums) {
  const auto* upper = green.ptr<std::uint8_t>(0);
  const auto* lower = green.ptr<std::uint8_t>(green.rows - 1);
  const auto count = static_cast<std::size_t>(green.cols);
  if (scale == 1) {
    std::copy(upper, upper + count, sums->begin());
    return;
  }
  for (std::size_t i = 0; i < count / 2; ++i) {
    (*sums)[i] =
        static_cast<std::uint16_t>(upper[2 * i] + upper[2 * i + 1] + lower[2 * i] + lower[2 * i + 1]);
  }
  if (count % 2 != 0) sums->back() = static_cast<std::uint16_t>(2 * (upper[count - 1] + lower[count - 1]));
}

// 1 2 1 along the row; beyond the ends it goes on with its last value.
void Smooth(const Line& in, Line* out) {
  const std::size_t last = in.size() - 1;
  const auto weighed = [](int a, int b, int c) { return static_cast<std::uint16_t>(a + 2 * b + c); };
  for (std::size_t i = 1; i < last; ++i) (*out)[i] = weighed(in[i - 1], in[i], in[i + 1]);
  (*out)[0] = weighed(in[0], in[0], in[std::min<std::size_t>(1, last)]);
  if (last > 0) (*out)[last] = weighed(in[last - 1], in[last], in[last]);
}

// A picture's light in whole numbers, times 16 times the pixels of each square, smoothed by (1 2 1) in either
// direction: three rows are kept of what is smoothed along the rows, each at its number modulo 3.
class SmoothRows {
 public:
  SmoothRows(const cv::Mat& bgr, int scale, cv::Size size)
      : bgr_(bgr), scale_(scale), size_(size), sums_(static_cast<std::size_t>(size.width)) {
    smooth_.fill(sums_);
    out_ = sums_;
  }

  // Rows must come one after the other.
  const Line& Find(int row) {
    for (int v = std::max(next_, row - 1); v <= row + 1; ++v) {
      if (v < 0 || v >= size_.height) continue;
      const cv::Rect rows(0, scale_ * v, bgr_.cols, std::min(scale_, bgr_.rows - scale_ * v));
      SumSquares(GreenChannel(bgr_(rows)), scale_, &sums_);
      Smooth(sums_, &At(v));
      next_ = v + 1;
    }
    const Line &above = At(std::max(0, row - 1)), &there = At(row),
               &below = At(std::min(size_.height - 1, row + 1));
    for (std::size_t i = 0; i < out_.size(); ++i)
      out_[i] = static_cast<std::uint16_t>(above[i] + 2 * there[i] + below[i]);
    return out_;
  }

 private:
  Line& At(int row) { return smooth_[static_cast<std::size_t>(row % 3)]; }

  const cv::Mat& bgr_;
  int scale_;
  cv::Size size_;
  int next_ = 0;
  Line sums_, out_;
  std::array<Line, 3> smooth_;
};

void Ratio(const Line& before, const Line& after, float least, float* out) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    out[i] = static_cast<float>(after[i]) / std::max(static_cast<float>(before[i]), least);
  }
  cv::hal::sqrt32f(out, out, static_cast<int>(before.size()));
}

}  // namespace

cv::Mat LedRatio(const cv::Mat& background, const cv::Mat& hand, int scale, const Context& context) {
  const cv::Size size((hand.cols + scale - 1) / scale, (hand.rows + scale - 1) / scale);
  const auto least = static_cast<float>(kDarkest * 16 * scale * scale);
  cv::Mat ratio(size, CV_32FC1);
  ParallelFor(context, 0, (size.height + kRows - 1) / kRows, [&](std::int64_t part) {
    const int first = static_cast<int>(part) * kRows;
    SmoothRows before(background, scale, size), after(hand, scale, size);
    for (int v = first; v < std::min(size.height, first + kRows); ++v)
      Ratio(before.Find(v), after.Find(v), least, ratio.ptr<float>(v));
  });
  return ratio;
}

}  // namespace dorsum
