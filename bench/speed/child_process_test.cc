// SPDX-License-Identifier: Apache-2.0
#include "speed/child_process.h"

#include <gtest/gtest.h>

namespace dorsum::speed {
namespace {

TEST(RunChild, MeasuresAProgramAndTellsOfFailures) {
  const auto good = RunChild({"/bin/sleep", "0.05"});
  ASSERT_TRUE(good.ok());
  EXPECT_GE(good->seconds, 0.05);
  EXPECT_GT(good->peak_mb, 0.1);
  EXPECT_FALSE(RunChild({"/bin/false"}).ok());
  EXPECT_FALSE(RunChild({"/nowhere/at-all"}).ok());
}

}  // namespace
}  // namespace dorsum::speed
