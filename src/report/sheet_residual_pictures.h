// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "calibration/bundle_calibration.h"
#include "report/plot.h"

namespace dorsum {

struct SheetResidualPictureOptions {
  cv::Size size{760, 430};  // px
};

// Scales that the pictures of one calibration share.
struct SheetResidualScales {
  Range miss_mm, y_mm, height_mm;
  Range order;
};
SheetResidualScales ScalesOf(const std::vector<SheetResidual>& residuals);

// What the light sheets of one laser leave, against y on the plane or against the order: a dot for each
// stripe point and a line through the means, coloured by the plane's height.
cv::Mat DrawSheetResidualsOverY(const std::vector<SheetResidual>& residuals, int laser,
                                const SheetResidualScales& scales,
                                const SheetResidualPictureOptions& options = {});
cv::Mat DrawSheetResidualsOverOrder(const std::vector<SheetResidual>& residuals, int laser,
                                    const SheetResidualScales& scales,
                                    const SheetResidualPictureOptions& options = {});

}  // namespace dorsum
