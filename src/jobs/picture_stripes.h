// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "captures/capture.h"
#include "imaging/unchanged_part.h"
#include "jobs/reconstruct_options.h"
#include "stripes/device_orders.h"
#include "stripes/shading.h"
#include "stripes/stripes.h"

namespace dorsum {

// What the lasers' pictures show, before anything is said about orders.
struct PictureStripes {
  std::vector<LaserStripes> stripes;     // of the lasers that are calibrated, wanted and in the capture
  std::map<int, LaserPicture> pictures;  // by laser; only ridges measure the noise
  // CV_8UC1, 255 where the picture shows nothing but the empty backplane, so that only some of its rows were
  // looked at; empty where every row was.
  cv::Mat empty;
  std::vector<LaserStripes> backplane;  // what those rows show there: points, without segments
};

// CaptureImages -> StripePoints and StripeSegments of all lasers, side by side. `region`: CV_8UC1, not 0
// where stripes are looked for. `unchanged`: the picture under the LEDs beside that of the backplane; null
// where the lasers and that picture are not compared. Then an error where the backplane's stripes do not lie
// where the calibration has them. `options` are resolved (ResolveStages).
Result<PictureStripes> FindPictureStripes(const CaptureImages& capture, const cv::Mat& region,
                                          const UnchangedPart* unchanged, const DeviceOrders& orders,
                                          const ReconstructOptions& options, const Context& context);

}  // namespace dorsum
