// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "device/frame_source.h"
#include "device/lights.h"
#include "device/virtual_bench.h"

namespace dorsum {

// The camera and the light controller of a virtual device, behind the interfaces of the real ones.
std::unique_ptr<FrameSource> MakeVirtualFrames(std::shared_ptr<VirtualBench> bench);
std::unique_ptr<Lights> MakeVirtualLights(std::shared_ptr<VirtualBench> bench);

}  // namespace dorsum
