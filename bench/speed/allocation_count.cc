// SPDX-License-Identifier: Apache-2.0
#include "speed/allocation_count.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

std::atomic<std::size_t> least{~std::size_t{0}};
std::atomic<long> counted{0};

void Note(std::size_t bytes) {
  if (bytes >= least.load(std::memory_order_relaxed)) counted.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

// glibc's own functions under their other names. What a program defines takes their place in all its
// libraries.
extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* old, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);

void* malloc(std::size_t bytes) {
  Note(bytes);
  return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
  Note(count * bytes);
  return __libc_calloc(count, bytes);
}
void* realloc(void* old, std::size_t bytes) {
  Note(bytes);
  return __libc_realloc(old, bytes);
}
void* memalign(std::size_t alignment, std::size_t bytes) {
  Note(bytes);
  return __libc_memalign(alignment, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** out, std::size_t alignment, std::size_t bytes) {
  *out = memalign(alignment, bytes);
  return *out == nullptr ? ENOMEM : 0;
}
}

namespace dorsum::speed {

AllocationCount::AllocationCount(std::size_t bytes) {
  counted = 0;
  least = bytes;
}
AllocationCount::~AllocationCount() { least = ~std::size_t{0}; }
long AllocationCount::count() const { return counted; }

}  // namespace dorsum::speed
