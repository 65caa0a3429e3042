// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "jobs/design.h"

namespace dorsum {

// The drawings of a design; see report/design_pictures.h.
struct DesignPictures {
  cv::Mat side, seen;                  // geometry from the side, backplane as the camera sees it
  cv::Mat depth, spacing, error, gap;  // curves: over x, and the last over the height
};
DesignPictures DrawDesign(const DesignReport& report);

// All of them on one sheet.
cv::Mat Overview(const DesignReport& report, const DesignPictures& pictures);

// The self-contained page.
std::string DesignPage(const DesignSummary& summary, const DesignPictures& pictures);

}  // namespace dorsum
