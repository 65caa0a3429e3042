// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_pool.h"

#include <cstdlib>
#include <memory>
#include <new>

#include <opencv2/core/utility.hpp>
#include <sys/mman.h>

namespace dorsum {
namespace {

constexpr std::size_t kSmall = std::size_t{64} << 10;  // bytes; the heap is good at these

constexpr std::size_t kHuge = std::size_t{2} << 20;  // bytes: the next larger page of x86-64 and of ARM

std::size_t Rounded(std::size_t bytes) {
  const std::size_t unit = bytes < kSmall ? 1 : bytes < kHuge / 2 ? kSmall : kHuge;
  return (bytes + unit - 1) / unit * unit;
}

// Pictures in large pages: the system hands these out in a tenth of the time, and the processor finds places
// in them sooner.
void* Allocate(std::size_t bytes) {
  if (bytes % kHuge != 0) return cv::fastMalloc(bytes);
  void* memory = std::aligned_alloc(kHuge, bytes);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  madvise(memory, bytes, MADV_HUGEPAGE);  // a wish; where it is not granted, pages are small
#endif
  return memory;
}

void Free(void* memory, std::size_t bytes) { bytes % kHuge != 0 ? cv::fastFree(memory) : std::free(memory); }

}  // namespace

PicturePool::~PicturePool() {
  for (const Block& block : unused_) Free(block.memory, block.bytes);
}

// At least `bytes`, which becomes how many there are: the smallest that is unused, if it is not twice too
// large.
void* PicturePool::Take(std::size_t* bytes) const {
  *bytes = Rounded(*bytes);
  if (*bytes >= kSmall) {
    const std::lock_guard lock(mutex_);
    auto best = unused_.end();
    for (auto block = unused_.begin(); block != unused_.end(); ++block) {
      const bool fits = block->bytes >= *bytes && block->bytes <= 2 * *bytes;
      if (fits && (best == unused_.end() || block->bytes < best->bytes)) best = block;
    }
    if (best != unused_.end()) {
      const Block block = *best;
      unused_.erase(best);
      unused_bytes_ -= block.bytes;
      *bytes = block.bytes;
      return block.memory;
    }
  }
  return Allocate(*bytes);
}

void PicturePool::Give(void* memory, std::size_t bytes) const {
  if (bytes < kSmall || bytes > most_) return Free(memory, bytes);
  const std::lock_guard lock(mutex_);
  unused_.push_back({bytes, memory});
  unused_bytes_ += bytes;
  auto kept = unused_.begin();
  for (; unused_bytes_ > most_; ++kept) {
    Free(kept->memory, kept->bytes);
    unused_bytes_ -= kept->bytes;
  }
  unused_.erase(unused_.begin(), kept);
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
  out->size = total;
  std::size_t capacity = total;
  out->data = out->origdata = static_cast<uchar*>(data != nullptr ? data : Take(&capacity));
  // A number that is nobody's address. NOLINTNEXTLINE(performance-no-int-to-ptr)
  out->userdata = reinterpret_cast<void*>(capacity);
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
  if ((own->flags & cv::UMatData::USER_ALLOCATED) == 0)
    Give(own->origdata, reinterpret_cast<std::size_t>(own->userdata));
}

void KeepPictureMemory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // Never destroyed: matrices may live to the program's end.
  static auto* const pool = new PicturePool;
  cv::Mat::setDefaultAllocator(pool);
#endif
}

}  // namespace dorsum
