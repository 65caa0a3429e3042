// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.h"

#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

Context Threads(int count) {
  Context context;
  context.threads = count;
  return context;
}

TEST(ParallelFor, CallsEveryIndexOnce) {
  for (const int threads : {0, 1, 2, 4}) {
    std::vector<int> calls(1000);
    ParallelFor(Threads(threads), 0, 1000, [&](std::int64_t i) { ++calls[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1)) << threads;
  }
}

TEST(ParallelFor, KeepsToItsRange) {
  std::vector<int> calls(10);
  ParallelFor(Threads(2), 3, 7, [&](std::int64_t i) { ++calls[static_cast<std::size_t>(i)]; });
  EXPECT_EQ(calls, (std::vector<int>{0, 0, 0, 1, 1, 1, 1, 0, 0, 0}));
  int none = 0;
  ParallelFor(Threads(1), 5, 5, [&](std::int64_t) { ++none; });
  ParallelFor(Threads(2), 5, 2, [&](std::int64_t) { ++none; });
  EXPECT_EQ(none, 0);
}

TEST(ParallelFor, OneThreadIsTheCallersOwnInOrder) {
  std::vector<std::int64_t> order;
  const auto caller = std::this_thread::get_id();
  ParallelFor(Threads(1), 0, 50, [&](std::int64_t i) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(i);
  });
  for (std::int64_t i = 0; i < 50; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(ParallelFor, RethrowsWhatABodyThrows) {
  for (const int threads : {1, 2}) {
    EXPECT_THROW(ParallelFor(Threads(threads), 0, 100,
                             [](std::int64_t i) {
                               if (i == 37) throw std::runtime_error("37");
                             }),
                 std::runtime_error);
  }
}

TEST(ParallelFor, MayBeNested) {
  std::vector<int> sums(8);
  ParallelFor(Threads(2), 0, 8, [&](std::int64_t i) {
    std::vector<int> inner(16);
    ParallelFor(Threads(2), 0, 16, [&](std::int64_t j) { inner[static_cast<std::size_t>(j)] = 1; });
    for (const int x : inner) sums[static_cast<std::size_t>(i)] += x;
  });
  EXPECT_EQ(sums, std::vector<int>(8, 16));
}

}  // namespace
}  // namespace dorsum
