// SPDX-License-Identifier: Apache-2.0
#include "report/overview.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "report/drawing.h"

namespace dorsum {
namespace {

constexpr int kGap = 18, kHeader = 92, kCaption = 40;
const Colour kCanvas{246, 244, 242};
const Colour kFrame{214, 208, 204};

// The colour of a picture's border, so that a tile's bars on the sides do not show as bars.
Colour EdgeColour(const cv::Mat& picture) {
  if (picture.empty() || picture.type() != CV_8UC3) return kPaper;
  const cv::Scalar mean = cv::mean(picture.row(0));
  return {cv::saturate_cast<unsigned char>(mean[0]), cv::saturate_cast<unsigned char>(mean[1]),
          cv::saturate_cast<unsigned char>(mean[2])};
}

}  // namespace

cv::Mat OverviewPicture(const std::string& title, const std::string& subtitle,
                        const std::vector<OverviewTile>& tiles, const OverviewOptions& options) {
  const int columns = std::max(1, options.columns), width = std::max(300, options.width_px);
  const int rows = (static_cast<int>(tiles.size()) + columns - 1) / columns;
  const int tile_width = (width - (columns + 1) * kGap) / columns, tile_height = tile_width * 3 / 4;
  const int row_height = tile_height + kCaption + kGap;
  cv::Mat canvas(kHeader + std::max(rows, 1) * row_height, width, CV_8UC3, Pen(kCanvas));
  DrawText(canvas, title, {double(kGap), 46.0}, {.size_px = 25.0, .bold = true});
  DrawText(canvas, subtitle, {double(kGap), 76.0}, {.size_px = 14.0, .colour = {105, 95, 88}});
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    const cv::Rect place(kGap + column * (tile_width + kGap), kHeader + row * row_height, tile_width,
                         tile_height);
    const cv::Mat& picture = tiles[i].picture;
    FitInto(picture, place.size(), EdgeColour(picture)).copyTo(canvas(place));
    cv::rectangle(canvas, place, Pen(kFrame), 1);
    DrawText(canvas, tiles[i].caption, {double(place.x), place.br().y + 26.0}, {.size_px = 14.0});
  }
  return canvas;
}

}  // namespace dorsum
