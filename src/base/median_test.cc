// SPDX-License-Identifier: Apache-2.0
#include "base/median.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(Median, IsTheMiddleTheUpperOfTwoAndNothingOfNone) {
  EXPECT_EQ(Median<double>({3.0, -1.0, 2.0}), 2.0);
  EXPECT_EQ(Median<float>({4.0F, 1.0F, 3.0F, 2.0F}), 3.0F);
  EXPECT_EQ(Median<double>({}), 0.0);
}

}  // namespace
}  // namespace dorsum
