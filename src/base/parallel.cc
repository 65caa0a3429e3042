// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.h"

#include <algorithm>

#if defined(__SANITIZE_THREAD__)
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace dorsum {
namespace {

#if defined(__SANITIZE_THREAD__)
int Processors() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

// TBB's own synchronisation is invisible to ThreadSanitizer, which then reports false races.
void RunThreaded(int threads, std::int64_t begin, std::int64_t end,
                 const std::function<void(std::int64_t)>& body) {
  std::atomic<std::int64_t> next{begin};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  std::vector<std::jthread> workers;
  for (int t = 0; t < threads; ++t) {
    workers.emplace_back([&] {
      try {
        for (std::int64_t i = next++; i < end; i = next++) body(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = end;
      }
    });
  }
  workers.clear();
  if (failure) std::rethrow_exception(failure);
}
#else
// Those that this process may use: a container or taskset may leave it fewer than the machine has.
int Processors() { return tbb::info::default_concurrency(); }

void RunThreaded(int threads, std::int64_t begin, std::int64_t end,
                 const std::function<void(std::int64_t)>& body) {
  const auto loop = [&] {
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(begin, end),
                      [&](const tbb::blocked_range<std::int64_t>& range) {
                        for (std::int64_t i = range.begin(); i != range.end(); ++i) body(i);
                      });
  };
  // A loop within another one has the outer one's threads at hand; waiting for its end, a thread must not
  // begin with another round of the outer one.
  if (tbb::this_task_arena::max_concurrency() == threads) return tbb::this_task_arena::isolate(loop);
  tbb::task_arena arena(threads);
  arena.execute(loop);
}
#endif

}  // namespace

// More threads than processors only wait for each other, and TBB warns about them.
int ThreadsOf(const Context& context) {
  const int available = Processors();
  return context.threads > 0 ? std::min(context.threads, available) : available;
}

void ParallelFor(const Context& context, std::int64_t begin, std::int64_t end,
                 const std::function<void(std::int64_t)>& body) {
  const int threads = ThreadsOf(context);
  if (threads == 1 || end - begin <= 1) {
    for (std::int64_t i = begin; i < end; ++i) body(i);
    return;
  }
  RunThreaded(threads, begin, end, body);
}

}  // namespace dorsum
