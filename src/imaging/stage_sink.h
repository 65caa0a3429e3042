// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "base/context.h"

namespace dorsum {

// Receives the intermediate images of a job under stable keys ("mask/difference", "stripes/2/mask"). The
// image is only valid during the call. Called from the job's own thread.
class StageSink {
 public:
  virtual ~StageSink() = default;
  virtual void Image(const std::string& key, const cv::Mat& image) = 0;
};

inline void Sink(const Context& context, const std::string& key, const cv::Mat& image) {
  if (context.sink != nullptr) context.sink->Image(key, image);
}

}  // namespace dorsum
