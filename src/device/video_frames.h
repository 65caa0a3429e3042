// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/context.h"
#include "captures/device_description.h"
#include "device/frame_source.h"
#include "device/video_input.h"

namespace dorsum {

// A camera, a network stream or a video file as frames, read in a thread of its own: whatever hangs there,
// Next() comes back in its time. Cameras and streams are read all the time and the newest four frames kept;
// of a recording every frame is given, as fast as asked for. Stamps are the driver's for a camera, else the
// frame's arrival. Damaged pictures are passed over and leave a gap in the numbers; so are the four pictures
// of a camera that are under way when its exposure is changed.
//
// Waits for the first picture, at most the limit for opening. A device error in one sentence: it cannot be
// opened or does not answer; no picture in time; a picture of another size than the description says; and
// later also: silence, closed by the other side, nothing but damaged pictures, the end of a recording. An
// error stays. Settings that a camera did not take are warnings.
//
// Destruction waits for the thread, which ends with its present call: at most after the limit for opening or
// for silence. A call that takes still longer (a driver or a name server that never answers) is abandoned:
// the thread ends when it returns, and touches nothing but what it owns.
Result<std::unique_ptr<FrameSource>> OpenVideoFrames(VideoKind kind, const std::string& place,
                                                     const CameraDesign& design, const VideoLimits& limits,
                                                     const Context& context);

// The same over any input: the function opens it, in the thread. `name` is for people.
using VideoOpener = std::function<Result<std::unique_ptr<VideoInput>>()>;
Result<std::unique_ptr<FrameSource>> OpenVideoFrames(VideoKind kind, const std::string& name,
                                                     VideoOpener opener, cv::Size size,
                                                     const VideoLimits& limits, const Context& context);

}  // namespace dorsum
