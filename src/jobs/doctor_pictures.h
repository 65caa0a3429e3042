// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "device/device.h"
#include "jobs/doctor.h"
#include "jobs/reconstruct.h"

namespace dorsum {

// The part of the examination that lights the lights: dark, LEDs, each laser alone, each with its own
// findings. With a calibration, the stripes on the part of the backplane that is as it was then are compared
// with where they belong: how far camera or laser have moved, px. Only an interrupt is an error.
Status LookAtPictures(Device& device, const ReadyCalibration* calibration, const Context& context,
                      std::vector<DoctorFinding>* findings);

}  // namespace dorsum
