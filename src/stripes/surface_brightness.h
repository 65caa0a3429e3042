// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

#include "stripes/brightness_ratio.h"
#include "stripes/stripes.h"

namespace dorsum {

struct SurfaceBrightnessOptions {
  double smooth_px = 0.8;  // of the picture's noise, one standard deviation, 0.3 to 10
  int margin_px = 2;       // pixels inside the outline that the blur mixes with what lies beyond, 0 to 20
  double window_px = 9.0;  // in which stripes are compared with the picture, one standard deviation, 3 to 50
};

// How bright the surface shines back the light of the lasers, relatively, at every pixel of the object.
// Colour and relief show in the picture under the LEDs. What the lasers' direction adds, and what only the
// LEDs do (the shadow of a thumb), shows in the ratio of the stripes' peaks to that picture, all lasers
// together, each stripe's own strength taken out: near any place the logarithm of the ratio is taken as
// linear in the place and in the picture's logarithm.
class SurfaceBrightness {
 public:
  // `green`: CV_8UC1, under the LEDs; `mask`: CV_8UC1, not 0 on the object. Stripes with an order, not yet
  // pooled, are compared with the picture.
  SurfaceBrightness(const cv::Mat& green, const cv::Mat& mask, const IndexedStripes& stripes,
                    const SurfaceBrightnessOptions& options, const Context& context = {});

  // Sets gain[x - first] for the columns x in [first, last] of row v: the brightness there over that at
  // column u, or at the nearest that is known; 0 off the object and in its margin. Returns the natural
  // logarithm of the brightness where gain is 1. Places where nothing is known have 1 throughout, and none is
  // returned.
  std::optional<double> Along(double u, int v, int first, int last, float* gain) const;

  // Natural logarithm of a stripe's peak over the surface's brightness; none where no stripe shows that.
  std::optional<double> StrengthOf(int laser, int order) const;

  // Natural logarithm of a stripe's peak at a point over what a stripe of that strength has on a surface as
  // bright as the brightest place within the stripe's width; none off the object.
  std::optional<double> RatioOf(double strength, const StripePoint& point, double width_px) const;

 private:
  bool IsInside(int u, int v) const;
  double LevelAt(double u, int v) const;
  std::map<int, std::vector<RatioSample>> SamplesByOrder(const LaserStripes& one) const;
  void Compare(const IndexedStripes& stripes, const Context& context);

  SurfaceBrightnessOptions options_;
  cv::Rect part_;
  cv::Mat1f level_;   // smoothed logarithm of the picture
  cv::Mat1b inside_;  // 255 on the object, further from its outline than the margin
  std::map<std::pair<int, int>, double>
      strength_;           // by laser and order: of the peak's logarithm over the level
  BrightnessRatio ratio_;  // within the part
};

}  // namespace dorsum
