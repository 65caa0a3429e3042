// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

#include "captures/device_description.h"
#include "device/frame_source.h"
#include "device/video_input.h"

namespace dorsum {

// What the tests of video_frames.h share: small grey pictures, and how a source ends.
inline const cv::Size kVideoSize(320, 240);

// A grey picture of that level with noise, so that no two are equal.
inline cv::Mat GreyPicture(int level, int seed = 0) {
  cv::Mat noise(kVideoSize, CV_16SC3), image;
  cv::RNG rng(static_cast<std::uint64_t>(seed) + 17);
  rng.fill(noise, cv::RNG::NORMAL, 0.0, 2.0);
  cv::add(cv::Mat(kVideoSize, CV_8UC3, cv::Scalar::all(level)), noise, image, cv::noArray(), CV_8U);
  return image;
}

inline double LevelOf(const cv::Mat& image) { return cv::mean(image)[1]; }

inline CameraDesign VideoDesign() {
  CameraDesign design;
  design.width = kVideoSize.width;
  design.height = kVideoSize.height;
  return design;
}

inline VideoLimits QuickLimits() { return {2.0, 0.5}; }

// The error that ends a source, after whatever frames still come.
inline Error ErrorAtTheEnd(FrameSource& source) {
  for (int i = 0; i < 1000; ++i) {
    const auto frame = source.Next(10.0);
    if (!frame.ok()) return frame.error();
  }
  return {ErrorCode::kInternal, "(no end)"};
}

}  // namespace dorsum
