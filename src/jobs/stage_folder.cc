// SPDX-License-Identifier: Apache-2.0
#include "jobs/stage_folder.h"

#include <algorithm>

#include "base/files.h"
#include "captures/png_image.h"

namespace dorsum {

void StageFolder::Image(const std::string& key, const cv::Mat& image) {
  if (!status_.ok() || image.empty()) return;
  std::error_code ec;
  std::filesystem::create_directories(folder_, ec);  // a failure shows when the file is written
  std::string name = key;
  std::replace(name.begin(), name.end(), '/', '_');
  status_ = WriteFile(folder_ / (name + ".png"), EncodePng(image));
}

}  // namespace dorsum
