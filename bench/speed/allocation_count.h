// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace dorsum::speed {

// Counts heap allocations of at least `bytes` while it lives, in all threads, however they are asked for.
class AllocationCount {
 public:
  explicit AllocationCount(std::size_t bytes);
  ~AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;

  long count() const;
};

}  // namespace dorsum::speed
