// SPDX-License-Identifier: Apache-2.0
#include "report/sheet_residual_pictures.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

std::vector<SheetResidual> Residuals(double slope_mm) {
  std::vector<SheetResidual> residuals;
  for (int order = -4; order <= 4; ++order) {
    for (const double height : {0.0, 50.0}) {
      for (double y = -90.0; y <= 90.0; y += 6.0) {
        SheetResidual r;
        r.laser = 1;
        r.order = order;
        r.height_mm = height;
        r.y_mm = y;
        r.miss_mm = slope_mm * y / 90.0;
        residuals.push_back(r);
      }
    }
  }
  return residuals;
}

// Mean row of what `picture` shows and `empty` does not, within columns.
double MeanRow(const cv::Mat& picture, const cv::Mat& empty, int from, int to) {
  cv::Mat difference;
  cv::absdiff(picture, empty, difference);
  cv::cvtColor(difference, difference, cv::COLOR_BGR2GRAY);
  double sum = 0.0, count = 0.0;
  for (int u = from; u < to; ++u) {
    for (int v = 0; v < picture.rows; ++v) {
      if (difference.at<std::uint8_t>(v, u) < 40) continue;
      sum += v;
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : -1.0;
}

TEST(SheetResidualPictures, APatternAlongYShows) {
  const auto residuals = Residuals(0.04);
  const SheetResidualScales scales = ScalesOf(residuals);
  const cv::Mat picture = DrawSheetResidualsOverY(residuals, 1, scales),
                empty = DrawSheetResidualsOverY(residuals, 2, scales);
  const int quarter = picture.cols / 4;
  const double left = MeanRow(picture, empty, quarter, 2 * quarter - 30),
               right = MeanRow(picture, empty, 2 * quarter, 3 * quarter - 30);
  EXPECT_GT(left, right + 40.0) << "misses grow with y, so the line rises to the right";
}

TEST(SheetResidualPictures, TheAxisReachesAsFarAsTheMisses) {
  auto residuals = Residuals(0.04);
  const SheetResidualScales scales = ScalesOf(residuals);
  const auto row = [&](double miss_mm) {
    for (SheetResidual& r : residuals) r.miss_mm = miss_mm;
    const cv::Mat picture = DrawSheetResidualsOverY(residuals, 1, scales),
                  empty = DrawSheetResidualsOverY(residuals, 2, scales);
    return MeanRow(picture, empty, picture.cols / 4, picture.cols / 2);
  };
  EXPECT_GT(row(0.01), row(0.03) + 20.0) << "both lie at the edge of the axis";
}

TEST(SheetResidualPictures, OfAnotherLaserNothingIsDrawn) {
  const auto residuals = Residuals(0.02);
  const SheetResidualScales scales = ScalesOf(residuals);
  const cv::Mat with = DrawSheetResidualsOverOrder(residuals, 1, scales),
                without = DrawSheetResidualsOverOrder(residuals, 2, scales);
  EXPECT_GT(cv::norm(with, without, cv::NORM_L1), 0.0);
  EXPECT_EQ(cv::norm(without, DrawSheetResidualsOverOrder({}, 1, scales), cv::NORM_L1), 0.0);
}

}  // namespace
}  // namespace dorsum
