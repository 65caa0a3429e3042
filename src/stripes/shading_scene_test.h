// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "base/random.h"
#include "stripes/append_segment.h"
#include "stripes/stripes.h"

namespace dorsum {

// A patch of surface, 200 x 160 px, whose brightness is given; seen under the LEDs and with upright stripes
// every 20 px.
struct ShadedScene {
  cv::Mat led, mask, lines;
  std::function<double(double, double)> brightness;  // of a column and row, 0 to 1

  ShadedScene(const std::function<double(double, double)>& bright, const cv::Rect& object,
              std::uint64_t seed = 3)
      : brightness(bright) {
    Rng rng(seed);
    led = cv::Mat(160, 200, CV_8UC1, cv::Scalar(0));
    lines = led.clone();
    mask = led.clone();
    mask(object) = 255;
    cv::Mat1f led_light(led.size()), line_light(led.size());
    for (int v = 0; v < led.rows; ++v) {
      for (int u = 0; u < led.cols; ++u) {
        const bool on = object.contains({u, v});
        const double reflected = on ? brightness(u, v) : 1.0;
        double light = 0.0;
        for (int k = 0; k < 10 && on; ++k) light += std::exp(-0.5 * std::pow((u - Centre(k)) / kWidth, 2.0));
        led_light(v, u) = static_cast<float>(160.0 * reflected);
        line_light(v, u) = static_cast<float>((4.0 + 150.0 * light) * reflected);
      }
    }
    for (cv::Mat1f* light : {&led_light, &line_light}) cv::GaussianBlur(*light, *light, {}, 0.8, 0.8);
    for (int v = 0; v < led.rows; ++v) {
      for (int u = 0; u < led.cols; ++u) {
        led.at<std::uint8_t>(v, u) = Grey(static_cast<double>(led_light(v, u)) + rng.Normal());
        lines.at<std::uint8_t>(v, u) = Grey(static_cast<double>(line_light(v, u)) + rng.Normal());
      }
    }
  }

  static constexpr double kWidth = 2.4;
  static double Centre(int stripe) { return 10.3 + 20.0 * stripe; }

  // Stripe k in the rows [10, 150), at `shift` px beside its centre, of order k.
  IndexedStripes Stripes(const std::function<bool(int)>& wanted, double shift = 0.0) const {
    IndexedStripes out;
    out.lasers.resize(1);
    for (int k = 0; k < 10; ++k) {
      if (!wanted(k)) continue;
      std::vector<StripePoint> points;
      for (int v = 10; v < 150; ++v) {
        StripePoint p;
        p.u = static_cast<float>(Centre(k) + shift);
        p.v = static_cast<float>(v);
        p.sd_px = 0.1F;
        p.width = static_cast<float>(kWidth);
        p.peak = static_cast<float>(150.0 * brightness(Centre(k), v));
        points.push_back(p);
      }
      AppendSegment(points, k, out.lasers.data());
    }
    return out;
  }

 private:
  static std::uint8_t Grey(double g) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(g, 0.0, 255.0)));
  }
};

}  // namespace dorsum
