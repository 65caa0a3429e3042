// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "device/frame_source.h"

namespace dorsum {

// Images of a folder as frames: all PNG and JPEG files in the order of their names, each given once and as
// fast as asked for, at the time when it is given; then a device error. A file that cannot be read as an
// image of the right size is an error that names it.
//
// Show() turns it into a still scene: from then on one image is given again and again, 30 times a second at
// most. Whoever knows which light is on can so replay a capture folder by its names (captures/names.h):
// Show("bgHand") under the LEDs, Show("stripesHand2") when laser 2 is on.
class FolderFrames : public FrameSource {
 public:
  // An error of input for a folder without images. An empty size takes that of the first image.
  static Result<std::unique_ptr<FolderFrames>> Open(const std::filesystem::path& folder, cv::Size size);

  // NAME.png, .jpg or .jpeg; an error of input where there is none, and then nothing changes.
  Status Show(const std::string& name);
  // The same with a black picture, for lights that are off.
  void ShowBlack();

  Result<Frame> Next(double timeout_s) override;
  Status ExposeFor(FrameLight) override { return {}; }  // they were exposed long ago

  cv::Size size() const override { return size_; }
  std::string name() const override { return "the folder " + folder_.string(); }
  std::vector<std::string> warnings() const override { return {}; }
  bool stamps_exposure() const override { return shows_; }

 private:
  FolderFrames(std::filesystem::path folder, std::vector<std::filesystem::path> files);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;
  cv::Size size_;
  std::size_t next_file_ = 0;
  std::int64_t given_ = 0;
  bool shows_ = false;
  cv::Mat shown_;
  double shown_at_s_ = 0.0;
};

}  // namespace dorsum
