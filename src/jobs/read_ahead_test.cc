// SPDX-License-Identifier: Apache-2.0
#include "jobs/read_ahead.h"

#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

Context WithThreads(int threads) {
  Context context;
  context.threads = threads;
  return context;
}

TEST(ReadAhead, EveryItemIsReadAndWorkedOnOnce) {
  for (const int threads : {1, 2}) {
    std::vector<int> seen(100, 0);
    std::vector<double> shares;
    Context context = WithThreads(threads);
    context.progress = [&](std::string_view, double share) { shares.push_back(share); };
    const Status status = ReadAhead<std::size_t>(
        seen.size(), context, [](std::size_t i) { return 3 * i; },
        [&](std::size_t i, const std::size_t& item) { seen[i] += item == 3 * i ? 1 : 1000; });
    EXPECT_TRUE(status.ok());
    EXPECT_EQ(seen, std::vector<int>(100, 1));
    ASSERT_FALSE(shares.empty());
    for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_GT(shares[i], shares[i - 1]);
  }
  EXPECT_TRUE(ReadAhead<int>(
                  0, {}, [](std::size_t) { return 1; }, [](std::size_t, const int&) {})
                  .ok());
}

TEST(ReadAhead, ReadsNoFurtherThanTheWorkersNeed) {
  std::atomic<int> read{0}, worked{0}, most{0};
  const Status status = ReadAhead<int>(
      50, WithThreads(1),
      [&](std::size_t) {
        const int ahead = ++read - worked;
        most = std::max(most.load(), ahead);
        return 0;
      },
      [&](std::size_t, const int&) { ++worked; });
  EXPECT_TRUE(status.ok());
  EXPECT_LE(most, 3) << "one worked on, one waiting, one being read";
}

TEST(ReadAhead, CancellingLeavesTheRest) {
  std::atomic<bool> cancel{false};
  std::atomic<int> worked{0};
  Context context = WithThreads(2);
  context.cancel = &cancel;
  const Status status = ReadAhead<int>(
      1000, context, [](std::size_t) { return 0; },
      [&](std::size_t, const int&) {
        if (++worked == 5) cancel = true;
      });
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kCancelled);
  EXPECT_GE(worked, 5);
  EXPECT_LT(worked, 50);
}

TEST(ReadAhead, AnExceptionOfEitherSideComesOut) {
  const auto nothing = [](std::size_t, const int&) {};
  EXPECT_THROW((void)ReadAhead<int>(
                   10, WithThreads(2),
                   [](std::size_t i) {
                     if (i == 4) throw std::runtime_error("read");
                     return 0;
                   },
                   nothing),
               std::runtime_error);
  EXPECT_THROW((void)ReadAhead<int>(
                   10, WithThreads(2), [](std::size_t) { return 0; },
                   [](std::size_t i, const int&) {
                     if (i == 4) throw std::runtime_error("work");
                   }),
               std::runtime_error);
}

}  // namespace
}  // namespace dorsum
