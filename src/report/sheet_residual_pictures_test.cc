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

// Mean row of what is drawn darkly (lines of means) within columns of the plot.
double MeanRow(const cv::Mat& picture, int from, int to) {
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  double sum = 0.0, count = 0.0;
  for (int u = from; u < to; ++u) {
    for (int v = 50; v < picture.rows - 80; ++v) {
      if (grey.at<std::uint8_t>(v, u) > 170) continue;
      sum += v;
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : -1.0;
}

TEST(SheetResidualPictures, APatternAlongYShows) {
  const auto residuals = Residuals(0.04);
  const cv::Mat picture = DrawSheetResidualsOverY(residuals, 1, ScalesOf(residuals));
  const int width = picture.cols - 200;
  const double left = MeanRow(picture, 110, 110 + width / 4),
               right = MeanRow(picture, 100 + 3 * width / 4, 80 + width);
  EXPECT_GT(left, right + 60.0) << "misses grow with y, so the line rises to the right";
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
