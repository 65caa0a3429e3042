// SPDX-License-Identifier: Apache-2.0
#include "captures/green_channel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "base/parallel.h"
#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "captures/green_channel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void TakeGreen(const std::uint8_t* bgr, std::size_t count, std::uint8_t* green) {
  const hn::ScalableTag<std::uint8_t> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    auto b = hn::Zero(d), g = b, r = b;
    hn::LoadInterleaved3(d, bgr + 3 * i, b, g, r);
    hn::StoreU(g, d, green + i);
  }
  for (; i < count; ++i) green[i] = bgr[3 * i + 1];
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(TakeGreen);

void TakeGreen(const std::uint8_t* bgr, std::size_t count, std::uint8_t* green) {
  HWY_DYNAMIC_DISPATCH(TakeGreen)(bgr, count, green);
}

cv::Mat GreenChannel(const cv::Mat& picture) {
  Context alone;
  alone.threads = 1;
  return GreenChannel(picture, alone);
}

cv::Mat GreenChannel(const cv::Mat& picture, const Context& context) {
  if (picture.type() == CV_8UC1) return picture;
  if (picture.type() != CV_8UC3) throw std::logic_error("GreenChannel: a CV_8UC3 picture is needed");
  cv::Mat green(picture.size(), CV_8UC1);
  constexpr int kRowsTogether = 64;
  ParallelFor(context, 0, (picture.rows + kRowsTogether - 1) / kRowsTogether, [&](std::int64_t block) {
    const int first = static_cast<int>(block) * kRowsTogether;
    for (int v = first; v < std::min(picture.rows, first + kRowsTogether); ++v) {
      TakeGreen(picture.ptr<std::uint8_t>(v), static_cast<std::size_t>(picture.cols),
                green.ptr<std::uint8_t>(v));
    }
  });
  return green;
}

}  // namespace dorsum
#endif
