// SPDX-License-Identifier: Apache-2.0
#include "device/picture_change.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

constexpr int kTiles = 32;
constexpr int kFiner = 8;               // the picture is first made small by so much less, then averaged
constexpr int kSampleRows = 64;         // rows of the picture from which noise is estimated
constexpr double kRounding = 0.3;       // grey levels that always may differ
constexpr double kFlicker = 0.02;       // share of the brightness: mains light beats with the exposure
constexpr double kNoiseSigmas = 4.0;    // of the mean of a band, whose tiles' differences are averaged
constexpr double kCorrelation = 2.0;    // noise of tiles over that of independent pixels: JPEG, interpolation
constexpr double kChangedShare = 0.10;  // of the bands
// Lasers are green, LEDs are white.
const cv::Matx13f kGrey(0.2F, 0.6F, 0.2F);

// Standard deviation of the difference of one pixel in two frames, from the differences' own differences
// between neighbours: these hold neither the picture nor the light, which both are smoother than noise.
double NoiseOfDifference(const cv::Mat& a, const cv::Mat& b) {
  const cv::Mat d = b - a;
  if (d.cols < 2) return 0.0;
  double sum = 0.0;
  for (int row = 0; row < d.rows; ++row) {
    const auto* p = d.ptr<float>(row);
    for (int i = 0; i + 1 < d.cols; ++i) sum += std::abs(double(p[i + 1]) - p[i]);
  }
  const double mean = sum / (double(d.rows) * (d.cols - 1));
  // E|x| = sigma sqrt(2 / pi) of a normal variable, and two pixels' noise is in each.
  return mean * std::sqrt(std::numbers::pi) / 2.0;
}

}  // namespace

PictureTiles TilesOf(const cv::Mat& bgr) {
  if (bgr.empty() || bgr.type() != CV_8UC3) throw std::logic_error("TilesOf() needs an 8-bit colour picture");
  PictureTiles tiles;
  const int columns = std::min(kTiles, bgr.cols), rows = std::min(kTiles, bgr.rows);
  // In two steps: the first is quick and rounds to whole grey levels, the second averages the rounding out.
  cv::Mat small;
  cv::resize(bgr, small, {std::min(kFiner * columns, bgr.cols), std::min(kFiner * rows, bgr.rows)}, 0, 0,
             cv::INTER_AREA);
  small.convertTo(small, CV_32F);
  cv::transform(small, small, kGrey);
  cv::resize(small, tiles.mean, {columns, rows}, 0, 0, cv::INTER_AREA);
  const int step = std::max(1, bgr.rows / kSampleRows);
  for (int row = 0; row < bgr.rows; row += step) tiles.grey.push_back(bgr.row(row));
  tiles.grey.convertTo(tiles.grey, CV_32F);
  cv::transform(tiles.grey, tiles.grey, kGrey);
  tiles.area = double(bgr.cols) * bgr.rows / (double(columns) * rows);
  return tiles;
}

PictureChange ChangeBetween(const PictureTiles& a, const PictureTiles& b) {
  if (a.mean.size() != b.mean.size() || a.grey.size() != b.grey.size())
    throw std::logic_error("ChangeBetween() of pictures of two sizes");
  const double pixel_noise = NoiseOfDifference(a.grey, b.grey);
  const double tile_noise = kCorrelation * pixel_noise / std::sqrt(a.area);
  // The mean of |x| is 0.8 sigma; that of a band scatters about it by 0.6 sigma over the root of its tiles.
  const double noise = tile_noise * (0.8 + kNoiseSigmas * 0.6 / std::sqrt(static_cast<double>(a.mean.cols)));
  PictureChange change;
  int changed = 0;
  for (int row = 0; row < a.mean.rows; ++row) {
    const double difference = cv::mean(cv::abs(b.mean.row(row) - a.mean.row(row)))[0];
    const double brightness = (cv::mean(a.mean.row(row))[0] + cv::mean(b.mean.row(row))[0]) / 2.0;
    change.worst_band = std::max(change.worst_band, difference);
    if (difference > kRounding + noise + kFlicker * brightness) ++changed;
  }
  change.changed_bands = static_cast<double>(changed) / a.mean.rows;
  return change;
}

bool Agree(const PictureChange& change) { return change.changed_bands == 0.0; }
bool ShowsOtherLight(const PictureChange& change) { return change.changed_bands >= kChangedShare; }

}  // namespace dorsum
