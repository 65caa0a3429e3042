// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_pool.h"

#include <memory>

#include <opencv2/core/utility.hpp>

namespace dorsum {
namespace {

constexpr std::size_t kSmall = std::size_t{64} << 10;  // bytes; the heap is good at these

// Sizes that differ little share their memory.
std::size_t Rounded(std::size_t bytes) { return (bytes + kSmall - 1) / kSmall * kSmall; }

}  // namespace

PicturePool::~PicturePool() {
  for (const auto& [bytes, list] : unused_) {
    for (void* memory : list) cv::fastFree(memory);
  }
}

void* PicturePool::Take(std::size_t bytes) const {
  if (bytes < kSmall) return cv::fastMalloc(bytes);
  const std::size_t size = Rounded(bytes);
  {
    const std::lock_guard lock(mutex_);
    const auto list = unused_.find(size);
    if (list != unused_.end() && !list->second.empty()) {
      void* memory = list->second.back();
      list->second.pop_back();
      unused_bytes_ -= size;
      return memory;
    }
  }
  return cv::fastMalloc(size);
}

void PicturePool::Give(void* memory, std::size_t bytes) const {
  const std::size_t size = Rounded(bytes);
  if (bytes >= kSmall) {
    const std::lock_guard lock(mutex_);
    if (unused_bytes_ + size <= most_) {
      unused_[size].push_back(memory);
      unused_bytes_ += size;
      return;
    }
  }
  cv::fastFree(memory);
}

std::size_t PicturePool::unused_bytes() const {
  const std::lock_guard lock(mutex_);
  return unused_bytes_;
}

// As cv::Mat's own allocator does it: steps of all dimensions, the last one of a single element.
cv::UMatData* PicturePool::allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                                    cv::AccessFlag /*flags*/, cv::UMatUsageFlags /*usage*/) const {
  auto total = static_cast<std::size_t>(CV_ELEM_SIZE(type));
  for (int i = dims - 1; i >= 0; --i) {
    if (step != nullptr) {
      if (data != nullptr && step[i] != static_cast<std::size_t>(cv::Mat::AUTO_STEP)) {
        total = step[i];
      } else {
        step[i] = total;
      }
    }
    total *= static_cast<std::size_t>(sizes[i]);
  }
  auto out = std::make_unique<cv::UMatData>(this);
  out->data = out->origdata = static_cast<uchar*>(data != nullptr ? data : Take(total));
  out->size = total;
  if (data != nullptr) out->flags |= cv::UMatData::USER_ALLOCATED;
  return out.release();
}

bool PicturePool::allocate(cv::UMatData* data, cv::AccessFlag /*access*/,
                           cv::UMatUsageFlags /*usage*/) const {
  return data != nullptr;
}

void PicturePool::deallocate(cv::UMatData* data) const {
  if (data == nullptr) return;
  const std::unique_ptr<cv::UMatData> own(data);
  if ((own->flags & cv::UMatData::USER_ALLOCATED) == 0) Give(own->origdata, own->size);
}

void KeepPictureMemory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // Never destroyed: matrices may live to the program's end.
  static auto* const pool = new PicturePool;
  cv::Mat::setDefaultAllocator(pool);
#endif
}

}  // namespace dorsum
