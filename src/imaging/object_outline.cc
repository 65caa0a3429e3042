// SPDX-License-Identifier: Apache-2.0
#include "imaging/object_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr float kStep = 0.5F;   // px between samples along a normal
constexpr int kSide = 4;        // samples on each side
constexpr int kNeighbours = 4;  // points on each side along the outline that a place is averaged with
constexpr float kStay = 0.05F;  // weight of staying, against 1 for a sharp edge

constexpr float kNoise = 4.0F;  // a change per px that noise may reach, in units of the texture

float Sample(const cv::Mat& image, cv::Point2f p) {
  const float x = std::clamp(p.x, 0.0F, static_cast<float>(image.cols - 1) - 1e-3F);
  const float y = std::clamp(p.y, 0.0F, static_cast<float>(image.rows - 1) - 1e-3F);
  const int u = static_cast<int>(x), v = static_cast<int>(y);
  const float a = x - static_cast<float>(u), b = y - static_cast<float>(v);
  const auto *upper = image.ptr<float>(v) + u, *lower = image.ptr<float>(v + 1) + u;
  return (1.0F - b) * ((1.0F - a) * upper[0] + a * upper[1]) + b * ((1.0F - a) * lower[0] + a * lower[1]);
}

std::size_t Wrapped(std::size_t i, int by, std::size_t size) {
  const auto n = static_cast<std::ptrdiff_t>(size);
  return static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(i) + by) % n + n) % n);
}

// Means over the neighbours along a closed curve, Gaussian weights.
template <class T>
std::vector<T> Smoothed(const std::vector<T>& values) {
  std::array<float, 2 * kNeighbours + 1> weights{};
  float total = 0.0F;
  for (int k = -kNeighbours; k <= kNeighbours; ++k) {
    const float w = std::exp(-0.5F * static_cast<float>(k * k) / (0.25F * kNeighbours * kNeighbours));
    weights[static_cast<std::size_t>(k + kNeighbours)] = w;
    total += w;
  }
  std::vector<T> out(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    T sum{};
    const bool wraps = i < kNeighbours || i + kNeighbours >= values.size();
    for (int k = -kNeighbours; k <= kNeighbours; ++k) {
      const std::size_t at =
          wraps ? Wrapped(i, k, values.size()) : i + static_cast<std::size_t>(k + kNeighbours) - kNeighbours;
      sum += values[at] * weights[static_cast<std::size_t>(k + kNeighbours)];
    }
    out[i] = sum * (1.0F / total);
  }
  return out;
}

struct Shift {
  float px;      // along the normal, outwards
  float weight;  // 0 to 1
};

// Where along the normal the light changes most: the centre of what is steep around the steepest sample.
Shift SteepestPlace(const cv::Mat& light, float texture, cv::Point2f place, cv::Point2f normal) {
  std::array<float, 2 * kSide + 2> levels{};
  for (int k = 0; k < 2 * kSide + 2; ++k) {
    const float way = (static_cast<float>(k - kSide) - 0.5F) * kStep;
    levels[static_cast<std::size_t>(k)] = Sample(light, place + way * normal);
  }
  std::array<float, 2 * kSide + 1> steps{};
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = (levels[k + 1] - levels[k]) / kStep;
  const auto* steepest = std::max_element(steps.begin(), steps.end(),
                                          [](float a, float b) { return std::abs(a) < std::abs(b); });
  const float sign = *steepest < 0.0F ? -1.0F : 1.0F, peak = std::abs(*steepest);
  const int at = static_cast<int>(steepest - steps.begin());
  float sum = 0.0F, moment = 0.0F;
  for (int k = std::max(0, at - 2); k <= std::min(2 * kSide, at + 2); ++k) {
    const float w = std::max(0.0F, sign * steps[static_cast<std::size_t>(k)] - 0.5F * peak);
    sum += w;
    moment += w * static_cast<float>(k - kSide) * kStep;
  }
  if (sum <= 0.0F) return {0.0F, 0.0F};
  const float excess = std::max(0.0F, peak / (kNoise * texture) - 1.0F);
  return {moment / sum, excess * excess / (1.0F + excess * excess)};
}

bool AtBorder(cv::Point2f p, cv::Size size) {
  return p.x < 1.5F || p.y < 1.5F || p.x > static_cast<float>(size.width) - 2.5F ||
         p.y > static_cast<float>(size.height) - 2.5F;
}

// A pixel of the border lies outwards by half a pixel on the side where the image ends.
cv::Point2f OntoBorder(cv::Point pixel, cv::Size size) {
  cv::Point2f p(pixel);
  if (pixel.x == 0) p.x -= 0.5F;
  if (pixel.y == 0) p.y -= 0.5F;
  if (pixel.x == size.width - 1) p.x += 0.5F;
  if (pixel.y == size.height - 1) p.y += 0.5F;
  return p;
}

// 0 to 1.
cv::Mat SmoothMask(const cv::Mat& mask, const Context& context) {
  constexpr int kRows = 64;  // that are smoothed together
  cv::Mat inside, smooth(mask.size(), CV_32FC1);
  mask.convertTo(inside, CV_32F, 1.0 / 255.0);
  ParallelFor(context, 0, (mask.rows + kRows - 1) / kRows, [&](std::int64_t block) {
    const int first = static_cast<int>(block) * kRows;
    const cv::Range rows(first, std::min(mask.rows, first + kRows));
    cv::Mat out = smooth.rowRange(rows);  // smoothed with the rows beside them
    cv::GaussianBlur(inside.rowRange(rows), out, {7, 7}, 1.5);
  });
  return smooth;
}

}  // namespace

Outlines FindOutlines(const cv::Mat& mask, const cv::Mat& light, const CellPicture& texture,
                      const Context& context) {
  std::vector<std::vector<cv::Point>> borders;
  cv::findContours(mask, borders, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  const cv::Mat inside = SmoothMask(mask, context);
  Outlines outlines;
  for (const std::vector<cv::Point>& border : borders) {
    const std::vector<cv::Point2f> pixels(border.begin(), border.end());
    std::vector<cv::Point2f> places = Smoothed(pixels), normals(pixels.size());
    std::vector<float> shifts(pixels.size(), 0.0F), weights(pixels.size(), 0.0F);
    ParallelFor(context, 0, static_cast<std::int64_t>(places.size()), [&](std::int64_t at) {
      const auto i = static_cast<std::size_t>(at);
      const cv::Point2f p = places[i];
      const cv::Point2f down(Sample(inside, p - cv::Point2f(1, 0)) - Sample(inside, p + cv::Point2f(1, 0)),
                             Sample(inside, p - cv::Point2f(0, 1)) - Sample(inside, p + cv::Point2f(0, 1)));
      const auto length = static_cast<float>(cv::norm(down));
      if (length > 0.0F) normals[i] = down * (1.0F / length);
      places[i] = p + 0.5F * normals[i];
      if (AtBorder(pixels[i], mask.size()) || length <= 0.0F) return;
      const float there = texture.At(border[i].x, border[i].y);
      const Shift shift = SteepestPlace(light, there, places[i], normals[i]);
      shifts[i] = shift.px * shift.weight;
      weights[i] = shift.weight;
    });
    shifts = Smoothed(shifts);
    weights = Smoothed(weights);
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i] = AtBorder(pixels[i], mask.size())
                      ? OntoBorder(border[i], mask.size())
                      : places[i] + shifts[i] / (weights[i] + kStay) * normals[i];
    }
    outlines.push_back(std::move(places));
  }
  return outlines;
}

cv::Mat FillOutlines(const Outlines& outlines, cv::Size size, const Context& context) {
  std::vector<std::vector<float>> crossings(static_cast<std::size_t>(size.height));
  for (const std::vector<cv::Point2f>& curve : outlines) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      cv::Point2f a = curve[i], b = curve[Wrapped(i, 1, curve.size())];
      if (a.y > b.y) std::swap(a, b);
      const int first = std::max(0, static_cast<int>(std::ceil(a.y)));
      for (int v = first; static_cast<float>(v) < b.y && v < size.height; ++v) {
        const float share = (static_cast<float>(v) - a.y) / (b.y - a.y);
        crossings[static_cast<std::size_t>(v)].push_back(a.x + share * (b.x - a.x));
      }
    }
  }
  cv::Mat mask(size, CV_8UC1);
  ParallelFor(context, 0, size.height, [&](std::int64_t v) {
    std::vector<float>& row = crossings[static_cast<std::size_t>(v)];
    std::sort(row.begin(), row.end());
    auto* out = mask.ptr<std::uint8_t>(static_cast<int>(v));
    std::fill_n(out, size.width, std::uint8_t{0});
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      const int first = std::max(0, static_cast<int>(std::ceil(row[i])));
      const int last = std::min(size.width - 1, static_cast<int>(std::floor(row[i + 1])));
      if (first <= last) std::fill(out + first, out + last + 1, std::uint8_t{255});
    }
  });
  return mask;
}

}  // namespace dorsum
