// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// What lens and narrow-band filter make of light (CV_32F): fall-off with the fourth power of the cosine and
// with the filter's angle, and the blur of the point spread function.
cv::Mat ThroughLens(const VirtualDevice& device, const cv::Mat& light, const Context& context);

// Multiplies laser light by speckle: a Gaussian field of the described contrast and grain, never below zero.
void AddSpeckle(const SpeckleDesign& speckle, std::uint64_t seed, cv::Mat& light, const Context& context);

// Electrons, noise and numbers: an 8-bit BGR picture of green light in which 1 is full scale. Noise depends
// on the seed, the channel and the pixel only. With a Bayer mosaic (RGGB, interpolated bilinearly) half of
// the pixels see the light as green ones do, a quarter each only what leaks into red and blue.
cv::Mat Digitise(const SensorDesign& sensor, const cv::Mat& light, std::uint64_t seed,
                 const Context& context);

}  // namespace dorsum
