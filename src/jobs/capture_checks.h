// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "captures/capture.h"
#include "jobs/reconstruct.h"

namespace dorsum {

struct CaptureCheckOptions {
  double min_light = 12.0;         // least rise over the dark picture that counts as lit, grey values
  double led_lit_share = 0.5;      // of the picture that the LEDs must light, 0 to 1
  double laser_lit_share = 0.002;  // of the picture that a laser's stripes must light, 0 to 1
  double saturated_share = 0.02;   // of the picture under the LEDs that may be at the sensor's end, 0 to 1
  double laser_saturated_share =
      0.1;                 // the same under a laser, whose central stripe is brighter than all else
  double max_dark = 60.0;  // brightest usual grey value without lights: daylight beyond spoils stripes
  double motion_warning_px = 0.5;  // between the first and the last picture
  double motion_limit_px = 2.0;    // the same; beyond it the capture is refused
};

// What is wrong with a picture or a capture, and whether taking it again may help.
enum class CaptureFault {
  kNone,
  kTooDark,     // LEDs or laser not lit
  kSaturated,   // overexposed
  kDaylight,    // too much light without the device's own
  kSameLaser,   // a picture shows the stripes of another laser's picture
  kWrongLaser,  // stripes lie where the calibration has those of another laser
  kMoved,       // the hand moved
  kCut,         // the hand leaves the picture at more than one place
};
struct CaptureFinding {
  CaptureFault fault = CaptureFault::kNone;
  std::string sentence;  // what is wrong and what to do

  bool ok() const { return fault == CaptureFault::kNone; }
  // Light and rest may be better the next time; exposure, wiring and the hand's place need somebody's hand.
  bool CanRetry() const { return fault == CaptureFault::kTooDark || fault == CaptureFault::kMoved; }
  Error ToError() const;  // a device error for light and wiring, bad input for the hand
};

// All pictures are CV_8UC3 of one size; `dark` was taken with all lights off.
CaptureFinding CheckDark(const cv::Mat& dark, const CaptureCheckOptions& options);
CaptureFinding CheckLeds(const cv::Mat& leds, const cv::Mat& dark, const CaptureCheckOptions& options);
CaptureFinding CheckLaser(const cv::Mat& lit, const cv::Mat& dark, int laser,
                          const CaptureCheckOptions& options);
// No two lasers' pictures show the same stripes: a cable is plugged twice, or a channel is named twice.
CaptureFinding CheckLasersDiffer(const CaptureImages& capture, const CaptureCheckOptions& options);
// bgHand against bgHandAfter; a small shift is only a warning.
CaptureFinding CheckRest(const CaptureImages& capture, const CaptureCheckOptions& options,
                         std::vector<std::string>* warnings);
// The hand and the lasers against a calibration: does each picture show its own laser, does the hand leave
// the picture at one place only. An error, in FindObject's words, where there is no object or the device is
// no longer as it was calibrated.
Result<CaptureFinding> CheckAgainstCalibration(const CaptureImages& capture, const ReadyCalibration& ready,
                                               const Context& context);

}  // namespace dorsum
