// SPDX-License-Identifier: Apache-2.0
#include "device/take_picture.h"

#include <algorithm>

#include "device/device_error.h"

namespace dorsum {
namespace {

constexpr double kRenderTime_s = 120.0;

Result<cv::Mat> TakeLit(Device& device, const ChannelSet& on, FrameLight light, StillOptions options,
                        const Context& context) {
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  if (device.bench) options.timeout_s = std::max(options.timeout_s, kRenderTime_s);
  DORSUM_RETURN_IF_ERROR(device.frames->ExposeFor(light));
  if (!device.frames->stamps_exposure()) {
    DORSUM_ASSIGN_OR_RETURN(const Frame before, device.frames->Next(options.timeout_s));
    options.before = before.image;
  }
  DORSUM_RETURN_IF_ERROR(device.lights->Set(on));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat picture,
                          TakeStill(*device.frames, MonotonicSeconds(), options, context));
  DORSUM_ASSIGN_OR_RETURN(const ChannelSet still_on, device.lights->On());
  if (still_on != on) {
    return DeviceError("the " + device.lights->info().name +
                       " switched its lights off while a picture was taken; it was reset, or its time limit "
                       "is shorter than the camera needs");
  }
  return picture;
}

}  // namespace

Result<cv::Mat> TakePicture(Device& device, const ChannelSet& on, FrameLight light,
                            const StillOptions& options, const Context& context) {
  Result<cv::Mat> picture = TakeLit(device, on, light, options, context);
  if (!picture.ok()) {
    // What went wrong first is what is told; a controller that cannot be reached switches off by itself.
    const Status off = device.lights->Set({});
    static_cast<void>(off);
  }
  return picture;
}

}  // namespace dorsum
