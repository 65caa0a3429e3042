// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_options.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(ReconstructOptionsTest, TheMethodDecidesEveryStageThatSaysAuto) {
  const ReconstructOptions ours = ResolveStages({});
  EXPECT_EQ(ours.mask, "robust");
  EXPECT_EQ(ours.stripes, "ridge");
  EXPECT_EQ(ours.indexing, "joint");
  EXPECT_EQ(ours.sheets, "cone");
  EXPECT_EQ(ours.correction, "none");
  EXPECT_EQ(ours.fusion, "robust");
  ReconstructOptions options;
  options.method = "classic";
  const ReconstructOptions theirs = ResolveStages(options);
  EXPECT_EQ(theirs.mask, "classic");
  EXPECT_EQ(theirs.stripes, "classic");
  EXPECT_EQ(theirs.indexing, "classic");
  EXPECT_EQ(theirs.sheets, "plane");
  EXPECT_EQ(theirs.correction, "polynomial");
  EXPECT_EQ(theirs.fusion, "classic");
}

// The correction is fitted to plane sheets: cones under the classic method must not get it unasked.
TEST(ReconstructOptionsTest, OneStageCanGoAnotherWay) {
  ReconstructOptions options;
  options.method = "classic";
  options.sheets = "cone";
  options.stripes = "ridge";
  const ReconstructOptions mixed = ResolveStages(options);
  EXPECT_EQ(mixed.stripes, "ridge");
  EXPECT_EQ(mixed.correction, "none");
  EXPECT_EQ(mixed.indexing, "classic");
  options.correction = "polynomial";
  EXPECT_EQ(ResolveStages(options).correction, "polynomial");
}

}  // namespace
}  // namespace dorsum
