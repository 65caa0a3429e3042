// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "device/device.h"
#include "jobs/campaign_add.h"

namespace dorsum {

// Makes the capture of `request` with an open device, which is told the calibration (of the request, or the
// campaign's present one), to know a hand from the backplane. A virtual device is visited by a hand that goes
// by the person's id, another one each time. What is to be told about the pictures comes into `warnings`, one
// sentence each. Device and warnings must outlive the maker.
CaptureMaker CaptureWithDevice(Device* device, const AddCaptureRequest& request,
                               std::vector<std::string>* warnings);

}  // namespace dorsum
