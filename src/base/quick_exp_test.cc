// SPDX-License-Identifier: Apache-2.0
#include "base/quick_exp.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(QuickExp, IsExpToASmallShare) {
  for (double x = -87.0; x <= 88.0; x += 0.0137) {
    const double truth = std::exp(static_cast<double>(static_cast<float>(x)));
    EXPECT_NEAR(static_cast<double>(QuickExp(static_cast<float>(x))) / truth, 1.0, 3e-7) << x;
  }
  EXPECT_EQ(QuickExp(0.0F), 1.0F);
}

}  // namespace
}  // namespace dorsum
