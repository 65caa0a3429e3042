// SPDX-License-Identifier: Apache-2.0
#include "captures/kept_pictures.h"

#include <utility>

namespace dorsum {

KeptPictures::KeptPictures(std::set<std::string> names, std::size_t most_bytes)
    : names_(std::move(names)), most_bytes_(most_bytes) {}

void KeptPictures::Put(const std::string& name, const cv::Mat& picture) {
  const std::size_t bytes = picture.total() * picture.elemSize();
  const std::lock_guard lock(mutex_);
  if (!Wants(name) || kept_.contains(name) || bytes > most_bytes_ - bytes_) return;
  kept_.emplace(name, picture);
  bytes_ += bytes;
}

std::optional<cv::Mat> KeptPictures::Find(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = kept_.find(name);
  return found == kept_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace dorsum
