// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "device/device.h"
#include "device/still_picture.h"

namespace dorsum {

// Switches exactly these lights on, waits until the camera shows them, and takes a settled picture.
// Afterwards asks the controller whether they are still on: where it has switched them off on its own (its
// time is up, or it was reset), the picture is not to be trusted, and that is a device error. The lights stay
// on, but after an error everything is off. A virtual camera gets all the time that rendering takes.
Result<cv::Mat> TakePicture(Device& device, const ChannelSet& on, FrameLight light,
                            const StillOptions& options, const Context& context);

}  // namespace dorsum
