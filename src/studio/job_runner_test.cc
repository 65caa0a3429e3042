// SPDX-License-Identifier: Apache-2.0
#include "studio/job_runner.h"

#include <QSignalSpy>
#include <QTest>
#include <stdexcept>

#include <gtest/gtest.h>

#include "studio/patience_test.h"

namespace dorsum {
namespace {

TEST(JobRunner, TheResultComesInTheWindowsThread) {
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::Finished), progressed(&runner, &JobRunner::Progressed);
  int value = 0;
  QThread* where = nullptr;
  runner.Run<int>(
      "six times seven",
      [](const Context& context) -> Result<int> {
        context.Report("multiplying", 0.5);
        return 42;
      },
      [&](Result<int> result) {
        value = *result;
        where = QThread::currentThread();
      });
  EXPECT_TRUE(runner.busy());
  ASSERT_TRUE(finished.wait(kPatience_ms));
  EXPECT_EQ(value, 42);
  EXPECT_EQ(where, runner.thread());
  EXPECT_FALSE(runner.busy());
  EXPECT_EQ(progressed.count(), 1);
}

TEST(JobRunner, AJobThatRunsCanBeCancelledAndAnotherRun) {
  JobRunner runner;
  for (int i = 0; i < 2; ++i) {
    QSignalSpy finished(&runner, &JobRunner::Finished);
    ErrorCode code = ErrorCode::kInternal;
    runner.Run<int>(
        "endless",
        [](const Context& context) -> Result<int> {
          while (!context.IsCancelled()) std::this_thread::yield();
          return Cancelled();
        },
        [&](const Result<int>& result) { code = result.error().code; });
    runner.Cancel();
    ASSERT_TRUE(finished.wait(kPatience_ms));
    EXPECT_EQ(code, ErrorCode::kCancelled);
  }
}

TEST(JobRunner, AJobThatReportsAllTheTimeDoesNotKeepTheWindowBusy) {
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::Finished), progressed(&runner, &JobRunner::Progressed);
  runner.Run<bool>(
      "chatter",
      [](const Context& context) -> Result<bool> {
        for (int i = 0; i < 100000; ++i) context.Report("talking", 1e-5 * i);
        context.Report("silent", 1.0);
        return true;
      },
      [](const Result<bool>&) {});
  ASSERT_TRUE(finished.wait(kPatience_ms));
  EXPECT_LT(progressed.count(), 10000);
  EXPECT_EQ(progressed.back().front().toString(), "silent");
}

TEST(JobRunner, OneJobAtATime) {
  JobRunner runner;
  const auto endless = [](const Context& context) -> Result<int> {
    while (!context.IsCancelled()) std::this_thread::yield();
    return Cancelled();
  };
  runner.Run<int>("one", endless, [](const Result<int>&) {});
  EXPECT_THROW(runner.Run<int>("two", endless, [](const Result<int>&) {}), std::logic_error);
}

TEST(JobRunner, ItGoesWhileItsJobRuns) {
  bool told = false;
  {
    JobRunner runner;
    runner.Run<int>(
        "endless",
        [](const Context& context) -> Result<int> {
          while (!context.IsCancelled()) std::this_thread::yield();
          return Cancelled();
        },
        [&](const Result<int>&) { told = true; });
  }
  QTest::qWait(10);
  EXPECT_FALSE(told);
}

}  // namespace
}  // namespace dorsum
