// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "calibration/correction_fit.h"
#include "report/plot.h"

namespace dorsum {

// Where the samples of a correction lie and how large their errors are, so that all pictures of one laser
// have the same axes and colours.
struct CorrectionScales {
  Range x, z;             // mm
  double error_mm = 1.0;  // the colour scale goes from minus this to this
};
CorrectionScales ScalesOf(const std::vector<HeightSample>& samples);

struct CorrectionPictureOptions {
  cv::Size size{640, 480};  // with axes and colour scale
};

// The height error z - h of each sample over (x, z), Figure 4.3(a) of the document. With a polynomial, what
// is left of it after the correction of equation 3.9.
cv::Mat DrawCorrectionSamples(const std::vector<HeightSample>& samples, const CorrectionScales& scales,
                              const CorrectionPolynomial& polynomial = {},
                              const CorrectionPictureOptions& options = {});

// The fitted height error z e(x, z) over (x, z), Figure 4.3(b) of the document.
cv::Mat DrawCorrectionPolynomial(const CorrectionPolynomial& polynomial, const CorrectionScales& scales,
                                 const CorrectionPictureOptions& options = {});

}  // namespace dorsum
