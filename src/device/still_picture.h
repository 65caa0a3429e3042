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
  // Where the light change shows nowhere and the stamps do not tell (FrameSource::stamps_exposure()), frames
  // are waited for at least so long, and five of them, in case old ones still come out of a queue; 0 to 60.
  double stale_s = 1.0;
  // What the scene looked like before the change, if at hand, else empty: a frame that differs from it is
  // known to be new. Without it the first frame given stands for it.
  cv::Mat before;
};

// A picture of a scene whose light changed at `changed_at_s` (MonotonicSeconds()). Passes over frames that
// were exposed before the change or during it, and waits until the light has settled: by their time stamps,
// and by what they show, for time stamps may be no better than the arrival of a frame that waited in a queue.
// Settled are two frames that show the new light and agree within their noise; the picture begins with the
// later one, since the earlier may still hold rows of the old light. A change that shows nowhere ends in the
// unchanged picture: whether the light is on is for the caller to judge. Time is the clock's or the newest
// frame's stamp, whichever is later. A device error when no settled picture comes in time or when a camera
// repeats itself byte for byte; Cancelled() when the context says so.
Result<cv::Mat> TakeStill(FrameSource& frames, double changed_at_s, const StillOptions& options,
                          const Context& context);

}  // namespace dorsum
