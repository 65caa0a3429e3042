// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include <opencv2/core.hpp>

namespace dorsum {

// Pictures of a folder that are read more than once, so that they are decoded only once. Of any thread.
// What it gives is shared: nobody may write to it.
class KeptPictures {
 public:
  // Keeps pictures of these names, as long as they take at most `most_bytes` together.
  explicit KeptPictures(std::set<std::string> names, std::size_t most_bytes = std::size_t{256} << 20);

  bool Wants(const std::string& name) const { return names_.contains(name); }
  void Put(const std::string& name, const cv::Mat& picture);
  std::optional<cv::Mat> Find(const std::string& name) const;

 private:
  const std::set<std::string> names_;
  const std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::map<std::string, cv::Mat> kept_;
  std::size_t bytes_ = 0;
};

}  // namespace dorsum
