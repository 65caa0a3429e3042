// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "imaging/stage_sink.h"

namespace dorsum {

// Writes every intermediate image of a job into a folder, as PNG: "stripes/2/mask" becomes
// stripes_2_mask.png. The pictures of the document's Figures 3.4 and 3.5 are made this way.
class StageFolder : public StageSink {
 public:
  // The folder is made when the first image comes.
  explicit StageFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void Image(const std::string& key, const cv::Mat& image) override;
  // The first failure to write, if there was one.
  const Status& status() const { return status_; }

 private:
  std::filesystem::path folder_;
  Status status_;
};

}  // namespace dorsum
