// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "captures/capture.h"
#include "imaging/hand_mask.h"
#include "jobs/reconstruct.h"
#include "stripes/stripes.h"

namespace dorsum {

// The object in the pictures of a capture: where it is, and the stripes on it with their orders.
struct FoundObject {
  HandMask mask;
  cv::Mat green_hand;  // the green channel of bgHand, CV_8UC1
  IndexedStripes stripes;
  std::vector<StripePoint> backplane;  // of all lasers
  std::vector<std::string> warnings;
};

// CaptureImages -> Mask -> StripePoints -> StripeSegments -> IndexedStripes. `options` are resolved
// (ResolveStages). An error when the picture shows no object, or when the stripes on the backplane do not lie
// where the calibration has them.
Result<FoundObject> FindObject(const CaptureImages& capture, const ReadyCalibration& ready,
                               const ReconstructOptions& options, const Context& context);

}  // namespace dorsum
