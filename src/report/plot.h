// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "report/colours.h"

namespace dorsum {

// A closed range of values on an axis or a colour scale.
struct Range {
  double low = 0.0, high = 1.0;
  double Span() const { return high - low; }
  double Share(double value) const { return (value - low) / Span(); }
};

// Round positions to label an axis with, about `count` of them.
std::vector<double> Ticks(const Range& range, int count);

// The range widened to its next round values; a usable one even for an empty or infinite range.
Range RoundOut(const Range& range, int count = 6);

// Part of a canvas that shows x to the right and y upwards.
struct PlotArea {
  cv::Rect pixels;
  Range x, y;
  cv::Point2d ToPixel(double px, double py) const {
    return {pixels.x + x.Share(px) * pixels.width, pixels.y + (1.0 - y.Share(py)) * pixels.height};
  }
  double XAt(double column) const { return x.low + (column + 0.5 - pixels.x) / pixels.width * x.Span(); }
  double YAt(double row) const { return y.high - (row + 0.5 - pixels.y) / pixels.height * y.Span(); }
};

// Faint grid lines at the ticks; drawn before the content.
void DrawGrid(cv::Mat& canvas, const PlotArea& area);

// Frame, ticks, numbers and the axes' names; drawn after the content. Needs 70 px to the left and 60 below.
void DrawAxes(cv::Mat& canvas, const PlotArea& area, const std::string& x_name, const std::string& y_name);

// Vertical colour scale with numbers to its right (70 px) and its name above, flush with the canvas's right.
void DrawColourScale(cv::Mat& canvas, const cv::Rect& bar, const Range& values, const std::string& name,
                     const std::function<Colour(double share)>& colour);

}  // namespace dorsum
