// SPDX-License-Identifier: Apache-2.0
#include "jobs/stage_folder.h"

#include <algorithm>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "base/files.h"

namespace dorsum {

void StageFolder::Image(const std::string& key, const cv::Mat& image) {
  if (!status_.ok() || image.empty()) return;
  std::error_code ec;
  std::filesystem::create_directories(folder_, ec);  // a failure shows when the file is written
  std::string name = key;
  std::replace(name.begin(), name.end(), '/', '_');
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", image, bytes)) {
    status_ = Error{ErrorCode::kInternal, "the stage " + key + " could not be encoded as PNG"};
    return;
  }
  status_ = WriteFile(folder_ / (name + ".png"), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace dorsum
