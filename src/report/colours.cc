// SPDX-License-Identifier: Apache-2.0
#include "report/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dorsum {
namespace {

constexpr int kTableSize = 256;
using Table = std::array<Colour, kTableSize>;

// Linear sRGB of a colour in Oklab's cylinder (Ottosson 2020): lightness, chroma, hue in degrees.
cv::Vec3d LinearRgb(double lightness, double chroma, double hue_deg) {
  const double hue = hue_deg * std::numbers::pi / 180.0;
  const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool IsDisplayable(const cv::Vec3d& rgb) {
  return std::all_of(rgb.val, rgb.val + 3, [](double v) { return v >= 0.0 && v <= 1.0; });
}

unsigned char EncodeSrgb(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * encoded));
}

// Where a screen cannot show the chroma, the nearest one that it can: clipping channels would change
// lightness.
Colour FromOklch(double lightness, double chroma, double hue_deg) {
  double low = 0.0, high = chroma;
  if (!IsDisplayable(LinearRgb(lightness, chroma, hue_deg))) {
    for (int i = 0; i < 30; ++i) {
      const double middle = 0.5 * (low + high);
      (IsDisplayable(LinearRgb(lightness, middle, hue_deg)) ? low : high) = middle;
    }
    chroma = low;
  }
  const cv::Vec3d rgb = LinearRgb(lightness, chroma, hue_deg);
  return {EncodeSrgb(rgb[2]), EncodeSrgb(rgb[1]), EncodeSrgb(rgb[0])};
}

Table MakeSequential() {
  Table table;
  for (int i = 0; i < kTableSize; ++i) {
    const double t = i / (kTableSize - 1.0);
    table[static_cast<std::size_t>(i)] = FromOklch(0.29 + 0.63 * t, 0.12 + 0.06 * t, 308.0 - 204.0 * t);
  }
  return table;
}

Table MakeDiverging() {
  Table table;
  for (int i = 0; i < kTableSize; ++i) {
    const double t = 2.0 * i / (kTableSize - 1.0) - 1.0, strength = std::abs(t);
    table[static_cast<std::size_t>(i)] =
        FromOklch(0.96 - 0.51 * strength, 0.19 * strength, t < 0.0 ? 255.0 : 27.0);
  }
  return table;
}

Colour LookUp(const Table& table, double t) {
  if (!std::isfinite(t)) return {128, 128, 128};
  return table[static_cast<std::size_t>(std::lround(std::clamp(t, 0.0, 1.0) * (kTableSize - 1)))];
}

}  // namespace

Colour SequentialColour(double t) {
  static const Table kTable = MakeSequential();
  return LookUp(kTable, t);
}

Colour DivergingColour(double t) {
  static const Table kTable = MakeDiverging();
  return LookUp(kTable, 0.5 * (t + 1.0));
}

Colour OrderColour(int order) {
  static const std::array<Colour, 6> kCycle = {Colour(255, 140, 152), Colour(30, 165, 255),
                                               Colour(255, 196, 40),  Colour(180, 90, 255),
                                               Colour(70, 225, 160),  Colour(70, 75, 240)};
  if (order == 0) return {255, 255, 255};
  return kCycle[static_cast<std::size_t>(((order % 6) + 6) % 6)];
}

Colour Mix(const Colour& a, const Colour& b, double share) {
  Colour out;
  for (int i = 0; i < 3; ++i) out[i] = cv::saturate_cast<unsigned char>((1.0 - share) * a[i] + share * b[i]);
  return out;
}

}  // namespace dorsum
