// SPDX-License-Identifier: Apache-2.0
#include "surface/sample_weights.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(SampleWeights, FallWithTheResidual) {
  PlateGrid grid;
  grid.lattice.step_px = 1.0;
  grid.lattice.active = cv::Mat1b(3, 3, std::uint8_t{255});
  grid.lattice.z = cv::Mat1f(3, 3, 5.0F);
  // On the surface, 1 mm beside it with much and with little weight, far from it, off the lattice, out of
  // use.
  std::vector<PlateSample> samples = {{1.0F, 1.0F, 5.0F, 100.0F}, {1.0F, 1.0F, 6.0F, 100.0F},
                                      {1.0F, 1.0F, 6.0F, 0.01F},  {1.0F, 1.0F, 25.0F, 100.0F},
                                      {9.0F, 9.0F, 6.0F, 7.0F},   {1.0F, 1.0F, 6.0F, 0.0F}};
  grid.places = FindPlaces(grid.lattice, samples);
  const std::vector<float> weights = Reweigh(samples, grid, 1.0, 3.0, {});
  EXPECT_FLOAT_EQ(weights[0], 100.0F);
  EXPECT_FLOAT_EQ(weights[1], 25.0F);  // one scale off: a quarter
  EXPECT_NEAR(weights[2], 0.01F, 1e-4F);
  EXPECT_LT(weights[3], 0.001F);
  EXPECT_FLOAT_EQ(weights[4], 7.0F);
  EXPECT_FLOAT_EQ(weights[5], 0.0F);
  SetWeights(weights, &samples);
  EXPECT_FLOAT_EQ(samples[1].weight, 25.0F);
  EXPECT_EQ(Heights(samples), (std::vector<float>{5.0F, 6.0F, 6.0F, 25.0F, 6.0F, 6.0F}));
}

}  // namespace
}  // namespace dorsum
