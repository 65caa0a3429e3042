// SPDX-License-Identifier: Apache-2.0
#include "jobs/capture_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "captures/green_channel.h"
#include "imaging/motion.h"
#include "imaging/unchanged_part.h"
#include "jobs/find_object.h"
#include "stripes/backplane_check.h"

namespace dorsum {
namespace {

std::string Percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
  return text;
}

std::string Pixels(double px) {
  char text[16];
  std::snprintf(text, sizeof text, "%.1f px", px);
  return text;
}

double ShareAbove(const cv::Mat& green, double value) {
  return static_cast<double>(cv::countNonZero(green > value)) / static_cast<double>(green.total());
}

cv::Mat RiseOf(const cv::Mat& lit, const cv::Mat& dark) {
  cv::Mat rise;
  cv::subtract(GreenChannel(lit), GreenChannel(dark), rise);
  return rise;
}

// How much two laser pictures show the same: the correlation of what is lit in either.
double Likeness(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat small_a, small_b, correlation;
  cv::GaussianBlur(GreenChannel(a), small_a, {}, 1.5);
  cv::GaussianBlur(GreenChannel(b), small_b, {}, 1.5);
  cv::matchTemplate(small_a, small_b, correlation, cv::TM_CCOEFF_NORMED);
  return static_cast<double>(correlation.at<float>(0, 0));
}

// The laser whose places on the backplane the stripes of a picture fit, if they are not those of `laser`.
std::optional<int> OtherLaser(const cv::Mat& picture, int laser, const ReadyCalibration& ready,
                              const cv::Mat& empty, const Context& context) {
  const RidgeOptions ridge;
  LaserStripes stripes;
  stripes.points =
      SurveyRidges(GreenChannel(picture), {}, ridge.width_px, ridge.detection, ridge.fit, context).points;
  const auto fits = [&](int k) {
    stripes.laser = k;
    const auto checks = CheckBackplane({stripes}, *ready.orders, empty, {});
    return !checks.empty() && checks[0].shift_px > 0.0 && !checks[0].moved;
  };
  if (fits(laser)) return std::nullopt;
  for (const LaserGeometry& other : ready.calibration.device.lasers) {
    if (other.laser != laser && fits(other.laser)) return other.laser;
  }
  return std::nullopt;
}

CaptureFinding CheckOwnLasers(const CaptureImages& capture, const ReadyCalibration& ready,
                              const Context& context) {
  const cv::Mat empty = UnchangedPart(ready.background, capture.hand).Mask(0.06);
  for (std::size_t k = 0; k < capture.stripes.size(); ++k) {
    if (!capture.stripes[k]) continue;
    const int laser = static_cast<int>(k);
    if (const auto other = OtherLaser(*capture.stripes[k], laser, ready, empty, context)) {
      const std::string own = std::to_string(laser), seen = std::to_string(*other);
      return {CaptureFault::kWrongLaser, "laser " + seen + " was lit in place of laser " + own +
                                             ": its cable is plugged elsewhere than when the device was "
                                             "calibrated, or a laser's channel in device.toml is wrong"};
    }
  }
  return {};
}

// Places at which the object leaves the picture: pieces of it along the border, walked around once.
int PlacesAtBorder(const cv::Mat& mask) {
  std::vector<bool> inside;
  const auto add = [&](int v, int u) { inside.push_back(mask.at<std::uint8_t>(v, u) != 0); };
  for (int u = 0; u < mask.cols; ++u) add(0, u);
  for (int v = 1; v < mask.rows; ++v) add(v, mask.cols - 1);
  for (int u = mask.cols - 2; u >= 0; --u) add(mask.rows - 1, u);
  for (int v = mask.rows - 2; v > 0; --v) add(v, 0);
  int places = 0;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    places += inside[i] && !inside[(i + inside.size() - 1) % inside.size()] ? 1 : 0;
  }
  return places;
}

}  // namespace

Error CaptureFinding::ToError() const {
  const bool device = fault != CaptureFault::kMoved && fault != CaptureFault::kCut;
  return {device ? ErrorCode::kDevice : ErrorCode::kBadInput, sentence};
}

CaptureFinding CheckDark(const cv::Mat& dark, const CaptureCheckOptions& options) {
  const double bright = ShareAbove(GreenChannel(dark), options.max_dark);
  if (bright <= 0.05) return {};
  return {CaptureFault::kDaylight, "with all lights off " + Percent(bright) +
                                       " of the picture is brighter than it may be; shade the device from "
                                       "daylight, or shorten the camera's exposure"};
}

CaptureFinding CheckLeds(const cv::Mat& leds, const cv::Mat& dark, const CaptureCheckOptions& options) {
  if (ShareAbove(RiseOf(leds, dark), options.min_light) < options.led_lit_share) {
    return {CaptureFault::kTooDark,
            "the LEDs light too little of the picture; check their supply and channel, or expose longer"};
  }
  const double saturated = ShareAbove(GreenChannel(leds), 253.0);
  if (saturated <= options.saturated_share) return {};
  return {CaptureFault::kSaturated, Percent(saturated) +
                                        " of the picture under the LEDs is overexposed; shorten the camera's "
                                        "exposure under the LEDs, or dim them"};
}

CaptureFinding CheckLaser(const cv::Mat& lit, const cv::Mat& dark, int laser,
                          const CaptureCheckOptions& options) {
  const std::string who = "laser " + std::to_string(laser);
  if (ShareAbove(RiseOf(lit, dark), options.min_light) < options.laser_lit_share) {
    return {CaptureFault::kTooDark, who + " does not light up; check its supply, its cable and its channel"};
  }
  const double saturated = ShareAbove(GreenChannel(lit), 253.0);
  if (saturated <= options.laser_saturated_share) return {};
  return {CaptureFault::kSaturated, Percent(saturated) + " of the picture under " + who +
                                        " is overexposed; shorten the camera's exposure for the lasers"};
}

CaptureFinding CheckLasersDiffer(const CaptureImages& capture, const CaptureCheckOptions& /*options*/) {
  constexpr double kSame = 0.9;
  for (std::size_t i = 0; i < capture.stripes.size(); ++i) {
    for (std::size_t j = i + 1; j < capture.stripes.size(); ++j) {
      if (!capture.stripes[i] || !capture.stripes[j]) continue;
      if (Likeness(*capture.stripes[i], *capture.stripes[j]) < kSame) continue;
      const std::string who = std::to_string(i) + " and " + std::to_string(j);
      return {CaptureFault::kSameLaser, "the pictures of lasers " + who +
                                            " show the same stripes; check their cables, and that their "
                                            "channels in device.toml differ"};
    }
  }
  return {};
}

CaptureFinding CheckRest(const CaptureImages& capture, const CaptureCheckOptions& options,
                         std::vector<std::string>* warnings) {
  if (!capture.hand_after) return {};
  const PictureMotion motion = MeasureMotion(capture.hand, *capture.hand_after);
  const std::string moved = "the hand moved by " + Pixels(motion.shift_px) + " while it was captured";
  if (motion.shift_px > options.motion_limit_px) {
    return {CaptureFault::kMoved, moved + "; rest it on the backplane and capture again"};
  }
  if (motion.shift_px > options.motion_warning_px) warnings->push_back(moved);
  return {};
}

Result<CaptureFinding> CheckAgainstCalibration(const CaptureImages& capture, const ReadyCalibration& ready,
                                               const Context& context) {
  if (CaptureFinding own = CheckOwnLasers(capture, ready, context); !own.ok()) return own;
  Context quiet = context;
  quiet.progress = nullptr;
  DORSUM_ASSIGN_OR_RETURN(const FoundObject found,
                          FindObject(capture, ready, ResolveStages(ReconstructOptions{}), quiet));
  if (PlacesAtBorder(found.mask.mask) <= 1) return CaptureFinding{};
  return CaptureFinding{CaptureFault::kCut,
                        "the hand leaves the picture at more than one place; move it to the middle, so that "
                        "only the wrist runs out"};
}

}  // namespace dorsum
