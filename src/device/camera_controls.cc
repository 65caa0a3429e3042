// SPDX-License-Identifier: Apache-2.0
#include "device/camera_controls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/videoio.hpp>

namespace dorsum {
namespace {

// Video4Linux counts the exposure in units of 100 us (V4L2_CID_EXPOSURE_ABSOLUTE), and its automatic
// exposure is a menu: 0 automatic, 1 manual, 2 and 3 half of each (V4L2_CID_EXPOSURE_AUTO).
constexpr double kExposureUnit_s = 1e-4;
constexpr double kManualExposure = 1.0;

std::string Text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string FourCcText(double value) {
  const auto code = static_cast<std::uint32_t>(std::max(0.0, value));
  std::string text;
  for (int shift = 0; shift < 32; shift += 8) {
    const char c = static_cast<char>(code >> shift & 0xffU);
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text;
}

std::string NotTaken(const std::string& what, const std::string& asked, const std::string& is) {
  return "the camera did not take " + what + " " + asked + (is.empty() ? "" : "; it is " + is);
}

// Sets and reads back. Nothing where the camera has the value, else the sentence that says so.
void Ask(CameraProperties& camera, int property, double value, const std::string& what,
         std::vector<std::string>& warnings, double unit = 1.0, const std::string& unit_name = "") {
  const bool taken = camera.Set(property, value);
  const double is = camera.Get(property);
  if (taken && std::abs(is - value) < 0.5) return;
  // Minus one is what VideoCapture says of a control that the camera does not have.
  const bool has_it = taken || is >= 0.0;
  warnings.push_back(has_it
                         ? NotTaken(what, Text(value * unit) + unit_name, Text(is * unit) + unit_name)
                         : NotTaken(what, Text(value * unit) + unit_name, "") + ": it has no such control");
}

}  // namespace

std::vector<std::string> SetFormat(const CameraDesign& design, CameraProperties& camera) {
  std::vector<std::string> warnings;
  const bool raw = design.stream_format == "raw";
  const int wanted = raw ? FourCc("YUYV") : FourCc("MJPG");
  camera.Set(cv::CAP_PROP_FOURCC, wanted);
  const double got = camera.Get(cv::CAP_PROP_FOURCC);
  const bool jpeg = got == FourCc("MJPG") || got == FourCc("JPEG");
  if (raw == jpeg)  // any format without loss is as good as the one that was asked for
    warnings.push_back(NotTaken("the stream format", raw ? "raw" : "mjpeg", FourCcText(got)));
  // Both together are one setting; the first waits for the second.
  camera.Set(cv::CAP_PROP_FRAME_WIDTH, design.width);
  camera.Set(cv::CAP_PROP_FRAME_HEIGHT, design.height);
  const double width = camera.Get(cv::CAP_PROP_FRAME_WIDTH), height = camera.Get(cv::CAP_PROP_FRAME_HEIGHT);
  if (width != design.width || height != design.height) {
    warnings.push_back(NotTaken("the resolution", Text(design.width) + "x" + Text(design.height),
                                Text(width) + "x" + Text(height)));
  }
  return warnings;
}

std::vector<std::string> SetControls(const CameraDesign& design, CameraProperties& camera) {
  std::vector<std::string> warnings;
  if (design.focus >= 0) {
    camera.Set(cv::CAP_PROP_AUTOFOCUS, 0);
    Ask(camera, cv::CAP_PROP_FOCUS, design.focus, "the focus", warnings);
  }
  if (design.white_balance_k > 0) {
    camera.Set(cv::CAP_PROP_AUTO_WB, 0);
    Ask(camera, cv::CAP_PROP_WB_TEMPERATURE, design.white_balance_k, "the white balance", warnings, 1.0,
        " K");
  }
  if (design.gain >= 0) Ask(camera, cv::CAP_PROP_GAIN, design.gain, "the gain", warnings);
  if (design.laser_exposure_s > 0.0) {
    // Some cameras refuse an exposure while they choose it themselves.
    Ask(camera, cv::CAP_PROP_AUTO_EXPOSURE, kManualExposure, "the manual exposure mode", warnings);
  } else {
    const double mode = camera.Get(cv::CAP_PROP_AUTO_EXPOSURE);
    if (mode >= 0.0 && mode != kManualExposure) {
      warnings.emplace_back(
          "the camera chooses its exposure itself, so pictures may not be comparable; set "
          "camera.laser_exposure_s and camera.led_exposure_s");
    }
  }
  return warnings;
}

std::vector<std::string> SetExposure(const CameraDesign& design, FrameLight light, CameraProperties& camera) {
  std::vector<std::string> warnings;
  const double exposure_s = light == FrameLight::kLaser ? design.laser_exposure_s : design.led_exposure_s;
  if (exposure_s <= 0.0) return warnings;
  Ask(camera, cv::CAP_PROP_EXPOSURE, std::round(exposure_s / kExposureUnit_s),
      light == FrameLight::kLaser ? "the exposure for lasers of" : "the exposure for LEDs of", warnings,
      kExposureUnit_s, " s");
  return warnings;
}

}  // namespace dorsum
