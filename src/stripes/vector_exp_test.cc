// SPDX-License-Identifier: Apache-2.0
#include "stripes/vector_exp.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(VectorExp, IsExpToASmallShareWhateverTheirNumber) {
  for (std::size_t count = 0; count < 70; ++count) {
    std::vector<float> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(-87.0F + 175.0F * static_cast<float>(i) / 69.0F);
    std::vector<float> raised = values;
    raised.push_back(7.0F);
    RaiseToExp({raised.data(), count});
    for (std::size_t i = 0; i < count; ++i) {
      const double truth = std::exp(static_cast<double>(values[i]));
      EXPECT_NEAR(static_cast<double>(raised[i]) / truth, 1.0, 3e-7) << values[i];
    }
    EXPECT_EQ(raised.back(), 7.0F);
  }
}

}  // namespace
}  // namespace dorsum
