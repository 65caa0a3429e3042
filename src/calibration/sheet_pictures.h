// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/bundle_problem.h"
#include "captures/calibration_series.h"
#include "stripes/pooling.h"
#include "stripes/ridge.h"
#include "stripes/stripes.h"

namespace dorsum {

struct SheetPictureOptions {
  RidgeOptions ridge;
  PoolingOptions pooling;
};

// One picture of one laser on planes of known height, with the stripes found in it.
struct SheetPicture {
  std::string name;         // "stripesBg2", "heights/h13.5/stripesHand2"
  std::string series;       // "backplane", "Further", "Closer", "box 13.5 mm"
  int laser = 0;            // index into the series' lasers
  std::vector<int> planes;  // which may be seen, the expected one first
  LaserStripes stripes;     // pooled along the stripe, where the options say
};

// Planes of a series: the backplane, the calibration object's top, from kFirstBoxPlane on the boxes' tops.
inline constexpr int kFirstBoxPlane = 2;
std::vector<HeightPlane> PlanesOfSeries(const CalibrationSeries& series);

// Reads every picture of stripes on planes of known height (§3.2) and finds its ridges. Without the heights/
// folder there are just fewer of them.
Result<std::vector<SheetPicture>> FindSheetPictures(const CalibrationSeries& series,
                                                    const SheetPictureOptions& options,
                                                    const Context& context);

}  // namespace dorsum
