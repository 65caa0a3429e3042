// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "device/attendant.h"
#include "device/device.h"

namespace dorsum {

struct LiveSeriesRequest {
  std::filesystem::path dir;  // the calibration folder; what is there already is kept
  int average = 1;            // frames averaged per picture, 1 to 64
  int tries = 5;              // how often a step is asked for before it is given up, 1 to 100
};

struct LiveSeriesSummary {
  int steps = 0, kept = 0;      // of the plan, and those whose pictures were there already
  double board_coverage = 0.0;  // share of the picture in which chessboard corners were seen
  std::vector<std::string> warnings;
};

// Leads through the calibration series of §3.2 (captures/series_plan.h) step by step: says what to arrange,
// lights the stripes that guide the hand, takes the step's pictures, and asks again where they show something
// else: no whole chessboard, one that was not moved, a light that is off. A step's pictures are written when
// all of them are good. What an earlier run has written is kept, so that a broken series goes on where it
// ended; setup.json tells whether it is of the same device.
Result<LiveSeriesSummary> TakeCalibrationSeries(Device& device, Attendant& attendant,
                                                const LiveSeriesRequest& request, const Context& context);

// The stripes by which a hand lays down what the step asks for; none where there is nothing to aim at.
ChannelSet GuideOf(const SeriesStep& step, const DeviceDescription& description);

}  // namespace dorsum
