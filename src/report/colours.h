// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

namespace dorsum {

// Colours are 8-bit sRGB in OpenCV's order, blue first.
using Colour = cv::Vec3b;

inline cv::Scalar Pen(const Colour& c) { return {double(c[0]), double(c[1]), double(c[2])}; }

// Violet over blue and green to yellow. Lightness grows evenly with t, so that the order of values survives
// grey printing and colour blindness. t is clamped to [0, 1].
Colour SequentialColour(double t);

// Blue below zero, near-white at zero, red above, for signed errors. t is clamped to [-1, 1].
Colour DivergingColour(double t);

// A colour for a diffraction order on a dark picture: white for the central one, a cycle of six for the
// others, in which neighbours differ in hue and lightness.
Colour OrderColour(int order);

// Weighted mean, share 0 gives a, 1 gives b.
Colour Mix(const Colour& a, const Colour& b, double share);

}  // namespace dorsum
