// SPDX-License-Identifier: Apache-2.0
#include "calibration/stripe_spacing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "calibration/chessboard.h"
#include "captures/green_channel.h"

namespace dorsum {
namespace {

// Counts stripes from the leftmost; where the step is about a whole multiple of its neighbour's, some are
// missing.
std::vector<int> CountWithGaps(const std::vector<double>& x) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < x.size(); ++i) steps.push_back(x[i] - x[i - 1]);
  const double usual = Median(steps);
  std::vector<int> index{0};
  for (const double step : steps)
    index.push_back(index.back() + std::max(1, static_cast<int>(std::lround(step / usual))));
  return index;
}

cv::Mat DrawSpacings(const cv::Mat& strip, const PlaneStripes& stripes) {
  cv::Mat picture = strip.clone();
  const auto column = [&](double x) {
    return static_cast<int>(
        std::lround((x - stripes.rectification.area_mm.x) * stripes.rectification.px_per_mm));
  };
  const int middle = picture.rows / 2;
  for (std::size_t i = 0; i < stripes.x_mm.size(); ++i) {
    const bool central = static_cast<int>(i) == stripes.central;
    const cv::Scalar colour = central ? cv::Scalar(60, 220, 255) : cv::Scalar(80, 80, 255);
    cv::line(picture, {column(stripes.x_mm[i]), 0}, {column(stripes.x_mm[i]), picture.rows - 1}, colour, 1,
             cv::LINE_AA);
    if (i == 0) continue;
    const cv::Point from(column(stripes.x_mm[i - 1]) + 3, middle), to(column(stripes.x_mm[i]) - 3, middle);
    cv::line(picture, from, to, {255, 140, 40}, 2, cv::LINE_AA);
  }
  return picture;
}

}  // namespace

Result<PlaneStripes> ObserveStripes(const CalibrationSeries& series, const Camera& camera, int laser,
                                    Distance distance, const StripeSpacingOptions& options,
                                    const Context& context, const std::vector<cv::Point2f>* known_corners,
                                    cv::Mat dark) {
  PlaneStripes out;
  const std::string name = LaserCalName(laser, distance), chess_name = LaserChessName(laser, distance);
  const cv::Size inner(series.setup.board_columns, series.setup.board_rows);
  std::optional<std::vector<cv::Point2f>> corners;
  if (known_corners != nullptr) {
    corners = *known_corners;
  } else {
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat chess, series.Read(chess_name, Channels::kGreen));
    corners = FindChessboard(chess, inner);
  }
  if (!corners) {
    return BadInput("no chessboard of " + std::to_string(inner.width) + "x" + std::to_string(inner.height) +
                    " inner corners is seen in " + chess_name + "; capture it again or correct setup.json");
  }
  out.rectification = RectifyFromBoard(camera, *corners, inner, series.setup.square_mm);
  Rectification strip = out.rectification;
  strip.area_mm.y = -options.band_mm;
  strip.area_mm.height = 2.0 * options.band_mm;

  DORSUM_ASSIGN_OR_RETURN(const cv::Mat lit, series.Read(name));
  if (dark.empty()) {
    DORSUM_ASSIGN_OR_RETURN(dark, series.Read(LaserBgName(distance)));
  }
  cv::Mat stripes;
  cv::subtract(lit, dark, stripes);
  const cv::Mat flat = WarpToPlane(stripes, camera, strip);
  const cv::Mat mask = ExtractStripeMask(flat, {}, options.mask, "calibration/" + name, context);
  const std::vector<VerticalLine> lines = FindVerticalLines(mask, GreenChannel(flat), options.lines);
  if (lines.size() < 3) {
    return BadInput("only " + std::to_string(lines.size()) + " stripes are seen in " + name + "; is laser " +
                    std::to_string(laser) + " on and the exposure long enough?");
  }
  for (const VerticalLine& line : lines) {
    out.x_mm.push_back(strip.area_mm.x + line.at / strip.px_per_mm);
    out.brightness.push_back(line.brightness);
  }
  out.index = CountWithGaps(out.x_mm);
  out.central = static_cast<int>(std::max_element(out.brightness.begin(), out.brightness.end()) -
                                 out.brightness.begin());
  out.picture = DrawSpacings(flat, out);
  return out;
}

double MeanSpacing(const PlaneStripes& stripes, int from, int to) {
  const int zero = stripes.index[static_cast<std::size_t>(stripes.central)];
  double first = 0.0, last = 0.0;
  int first_order = 0, last_order = 0;
  bool any = false;
  for (std::size_t i = 0; i < stripes.x_mm.size(); ++i) {
    const int order = stripes.index[i] - zero;
    if (order < from || order > to) continue;
    if (!any) {
      first = stripes.x_mm[i];
      first_order = order;
      any = true;
    }
    last = stripes.x_mm[i];
    last_order = order;
  }
  return last_order > first_order ? (last - first) / (last_order - first_order) : 0.0;
}

}  // namespace dorsum
