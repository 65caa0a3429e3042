// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "captures/series_plan.h"

namespace dorsum {

class VirtualBench;

// Who puts things before a device and takes them away: a person who reads what to do, or the virtual device's
// own hands.
class Attendant {
 public:
  virtual ~Attendant() = default;

  // Returns when the step's arrangement stands. `words` say what to do, and when it is asked for again, what
  // was wrong. `keep_lit` is to be called at least once a second while waiting: it keeps the guiding stripes
  // on. Cancelled() when the person gives up.
  virtual Status Arrange(const SeriesStep& step, const std::string& words,
                         const std::function<Status()>& keep_lit, const Context& context) = 0;
  // Says what was seen: a sentence.
  virtual void Tell(const std::string& words) = 0;
  // A chessboard that counts towards what the boards of the series cover: its corners in the picture, px.
  virtual void SawBoard(const std::vector<cv::Point2f>& /*corners*/) {}
  // The step's pictures are in the folder, from now or from an earlier run.
  virtual void StepDone(const SeriesStep& /*step*/) {}
};

std::unique_ptr<Attendant> MakeVirtualAttendant(std::shared_ptr<VirtualBench> bench);

}  // namespace dorsum
