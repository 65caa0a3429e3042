// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/context.h"
#include "base/parallel.h"

namespace dorsum {

// Reads the items 0 .. count - 1 in one thread and works on them in as many as the context allows, each item
// in one of them; as many items as there are workers wait at most. work(i, item) may come in any order. The
// caller's thread reports progress. Returns when all is done, or, cancelled, when the present items are: then
// the rest was not worked on. The first exception of either function is rethrown.
template <class Item>
Status ReadAhead(std::size_t count, const Context& context, const std::function<Item(std::size_t)>& read,
                 const std::function<void(std::size_t, const Item&)>& work) {
  if (count == 0) return {};
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::pair<std::size_t, Item>> waiting;
  std::size_t done = 0;
  bool all_read = false, stop = false;
  std::exception_ptr failure;
  const auto workers = std::min(static_cast<std::size_t>(ThreadsOf(context)), count);
  const auto guarded = [&](const auto& body) {
    try {
      body();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
      changed.notify_all();
    }
  };
  const auto ended = [&] { return stop || context.IsCancelled(); };

  std::vector<std::jthread> threads;
  threads.emplace_back([&] {
    guarded([&] {
      for (std::size_t i = 0; i < count; ++i) {
        {
          std::unique_lock lock(mutex);
          changed.wait(lock, [&] { return waiting.size() < workers || ended(); });
          if (ended()) break;
        }
        Item item = read(i);
        const std::lock_guard lock(mutex);
        waiting.emplace_back(i, std::move(item));
        changed.notify_all();
      }
    });
    const std::lock_guard lock(mutex);
    all_read = true;
    changed.notify_all();
  });
  for (std::size_t k = 0; k < workers; ++k) {
    threads.emplace_back([&] {
      guarded([&] {
        for (;;) {
          std::unique_lock lock(mutex);
          changed.wait(lock, [&] { return !waiting.empty() || all_read || ended(); });
          if (ended() || waiting.empty()) return;
          const std::pair<std::size_t, Item> next = std::move(waiting.front());
          waiting.pop_front();
          changed.notify_all();
          lock.unlock();
          work(next.first, next.second);
          lock.lock();
          ++done;
          changed.notify_all();
        }
      });
    });
  }
  {
    std::unique_lock lock(mutex);
    std::size_t reported = count + 1;
    for (;;) {
      if (done != reported) {
        reported = done;
        lock.unlock();
        context.Report(std::to_string(reported) + " of " + std::to_string(count),
                       static_cast<double>(reported) / static_cast<double>(count));
        lock.lock();
        continue;
      }
      if (done == count || stop) break;
      // Nobody wakes us when the job is cancelled, so look now and then.
      changed.wait_for(lock, std::chrono::milliseconds(50));
      if (context.IsCancelled()) stop = true;
    }
    changed.notify_all();
  }
  threads.clear();
  if (failure) std::rethrow_exception(failure);
  return done < count ? context.CheckCancelled() : Status();
}

}  // namespace dorsum
