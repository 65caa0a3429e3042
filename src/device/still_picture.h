// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "device/frame_source.h"

namespace dorsum {

struct StillOptions {
  double delay_s = 0.03;   // frames exposed sooner than this after the light changed are passed over, 0 to 10
  double timeout_s = 5.0;  // without a settled picture it is an error, 0.1 to 120
  int average = 1;         // frames averaged, 1 to 64
};

// A picture of a scene whose light changed at `changed_at_s` (MonotonicSeconds()). Passes over frames that
// were exposed before the change or during it, and waits until the light has settled: by their time stamps,
// and by what they show, for time stamps may be no better than the arrival of a frame that waited in a queue.
// A device error when no settled picture comes in time, Cancelled() when the context says so.
Result<cv::Mat> TakeStill(FrameSource& frames, double changed_at_s, const StillOptions& options,
                          const Context& context);

}  // namespace dorsum
