// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "imaging/stage_sink.h"
#include "jobs/reconstruct.h"
#include "studio/workbench.h"

namespace dorsum {

// Keeps a job's intermediate images, 8 bits deep and each under its key. For one job at a time; read it when
// that is done.
class StageCollector : public StageSink {
 public:
  void Image(const std::string& key, const cv::Mat& image) override;
  std::map<std::string, cv::Mat> Take() { return std::move(images_); }

 private:
  std::map<std::string, cv::Mat> images_;  // CV_8UC1 or CV_8UC3
};

// What one way of reconstructing a capture showed on its way.
struct ChainStages {
  std::map<std::string, cv::Mat> pictures;  // CV_8UC1 or CV_8UC3, by key
  std::size_t points = 0, faces = 0;
  double seconds = 0.0;        // of computation, without the drawing
  std::optional<Error> error;  // why it ended early; the pictures until then are there
};

// The document's chain beside ours, with the same parameters. Keys: those of the stage sink, and drawn from
// the result "stripes/K/points" (what was found, over the laser's picture), "orders/K" (stripes by order),
// "points/K" (by height) for each laser K, and "heights". Colours of heights mean the same on both sides.
struct StageComparison {
  ChainStages classic, ours;
  std::vector<std::string> keys;  // of either, in the order of the chain
  std::set<std::string> changed;  // keys whose pictures differ from those of the comparison before
};

// Runs both. `before` may be none. A chain that fails is told in it; only cancelling is an error.
Result<std::shared_ptr<const StageComparison>> CompareStages(const Scan& scan,
                                                             const ReconstructOptions& options,
                                                             const StageComparison* before,
                                                             const Context& context);

}  // namespace dorsum
