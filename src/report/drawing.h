// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "report/colours.h"

namespace dorsum {

inline const Colour kInk{40, 34, 30};       // text and axes on a light canvas
inline const Colour kFaint{206, 200, 196};  // grid lines on a light canvas
inline const Colour kPaper{255, 255, 255};

enum class Align { kLeft, kCentre, kRight };

struct TextStyle {
  double size_px = 14.0;  // height of capital letters
  Colour colour = kInk;
  Align align = Align::kLeft;
  bool bold = false;
};

// Size of a line of text, px: width, and height of capital letters.
cv::Size MeasureText(const std::string& text, const TextStyle& style);

// Draws a line of text; `at` is its left end, middle or right end on the baseline. The drawing font has ASCII
// only, so other characters become question marks.
void DrawText(cv::Mat& canvas, const std::string& text, cv::Point2d at, const TextStyle& style);

// The same, running upwards.
void DrawTextUpwards(cv::Mat& canvas, const std::string& text, cv::Point2d at, const TextStyle& style);

// Anti-aliased line with sub-pixel ends.
void DrawLine(cv::Mat& canvas, cv::Point2d a, cv::Point2d b, const Colour& colour, int thickness = 1);

// "12.5", with the given number of decimals and without a negative zero.
std::string FormatNumber(double value, int decimals);

// Scaled to fill a canvas of this size without cutting anything; the rest has the colour `margin`.
cv::Mat FitInto(const cv::Mat& picture, cv::Size size, const Colour& margin = kPaper);

}  // namespace dorsum
