// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// Keeps the memory of pictures that are gone for the next ones of about their size, so that a program that
// scans again and again asks the system for none. Of any thread. Small matrices go to the heap as always.
class PicturePool : public cv::MatAllocator {
 public:
  // Beyond `most_bytes` of unused memory, what was not used for longest is freed.
  explicit PicturePool(std::size_t most_bytes = std::size_t{128} << 20) : most_(most_bytes) {}
  ~PicturePool() override;
  PicturePool(const PicturePool&) = delete;
  PicturePool& operator=(const PicturePool&) = delete;

  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override;
  bool allocate(cv::UMatData* data, cv::AccessFlag access, cv::UMatUsageFlags usage) const override;
  void deallocate(cv::UMatData* data) const override;

  std::size_t unused_bytes() const;

 private:
  struct Block {
    std::size_t bytes;
    void* memory;
  };
  void* Take(std::size_t* bytes) const;
  void Give(void* memory, std::size_t bytes) const;

  const std::size_t most_;
  mutable std::mutex mutex_;
  mutable std::vector<Block> unused_;  // what was given back first is first
  mutable std::size_t unused_bytes_ = 0;
};

// For programs that scan, at their beginning: all matrices of the program live in a pool. Not under a
// sanitizer, which could then not see who uses what is gone.
void KeepPictureMemory();

}  // namespace dorsum
