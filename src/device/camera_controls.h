// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "captures/device_description.h"
#include "device/frame_source.h"

namespace dorsum {

// The code of a format, of four letters: "MJPG".
constexpr int FourCc(const char* name) { return name[0] | name[1] << 8 | name[2] << 16 | name[3] << 24; }

// The properties of a camera as cv::VideoCapture has them: cv::CAP_PROP_… and a number.
class CameraProperties {
 public:
  virtual ~CameraProperties() = default;
  virtual bool Set(int property, double value) = 0;
  virtual double Get(int property) const = 0;  // -1 where there is none
};

// Asks for format and resolution, which has to be before the first picture. A sentence for each that the
// camera did not take, with what was asked for and what it is.
std::vector<std::string> SetFormat(const CameraDesign& design, CameraProperties& camera);

// Switches off what the camera would do on its own, and sets focus, white balance and gain, so far as the
// description gives them. To be called when pictures come: some cameras forget earlier settings.
std::vector<std::string> SetControls(const CameraDesign& design, CameraProperties& camera);

// Sets the exposure for pictures of that light, if the description gives one.
std::vector<std::string> SetExposure(const CameraDesign& design, FrameLight light, CameraProperties& camera);

}  // namespace dorsum
