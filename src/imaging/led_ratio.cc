// SPDX-License-Identifier: Apache-2.0
#include "imaging/led_ratio.h"

#include <cstdint>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "captures/green_channel.h"

namespace dorsum {
namespace {

constexpr double kDarkest = 6.0;  // grey values; below it the ratio is noise

cv::Mat Green(const cv::Mat& image, int scale) {
  cv::Mat green = GreenChannel(image), out;
  if (scale == 2) {
    cv::copyMakeBorder(green, green, 0, green.rows % 2, 0, green.cols % 2, cv::BORDER_REPLICATE);
    green.convertTo(green, CV_16U, 16.0);  // the mean of four keeps its fraction
    cv::resize(green, green, {}, 0.5, 0.5, cv::INTER_AREA);
    green.convertTo(out, CV_32F, 1.0 / 16.0);
  } else {
    green.convertTo(out, CV_32F);
  }
  cv::GaussianBlur(out, out, {3, 3}, 0.0, 0.0, cv::BORDER_REPLICATE);
  return out;
}

}  // namespace

cv::Mat LedRatio(const cv::Mat& background, const cv::Mat& hand, int scale, const Context& context) {
  cv::Mat before, after;
  ParallelFor(context, 0, 2,
              [&](std::int64_t i) { (i == 0 ? before : after) = Green(i == 0 ? background : hand, scale); });
  cv::max(before, kDarkest, before);
  cv::divide(after, before, after);
  cv::sqrt(after, after);
  return after;
}

}  // namespace dorsum
