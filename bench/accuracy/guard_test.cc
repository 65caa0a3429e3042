// SPDX-License-Identifier: Apache-2.0
#include "accuracy/guard.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum::accuracy {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Results TwoRungs(double classic_rmse, double default_rmse) {
  Results results{"test", {}};
  for (const auto& [rung, rmse] :
       {std::pair("classic", classic_rmse), std::pair("+ sheets cone", default_rmse)}) {
    DeviceResult device;
    device.design = "short";
    device.rung = rung;
    CaptureResult box;
    box.name = "box25.5";
    box.figures = {{"z_rmse", rmse}, {"complete", 0.98}, {"wrong", 0.0}};
    device.captures.push_back(box);
    results.devices.push_back(device);
  }
  return results;
}

TEST(GuardTest, WhatWasRecordedPassesAndWhatIsWorseIsNamed) {
  const LimitTable limits = RecordLimits(TwoRungs(0.5, 0.05));
  EXPECT_THAT(Regressions(TwoRungs(0.5, 0.05), limits), IsEmpty());
  EXPECT_THAT(Regressions(TwoRungs(0.5, 0.054), limits), IsEmpty());
  const auto worse = Regressions(TwoRungs(0.5, 0.056), limits);
  ASSERT_EQ(worse.size(), 1U);
  EXPECT_THAT(worse[0], HasSubstr("default / box25.5: z_rmse is 0.056"));
}

TEST(GuardTest, ARefusedOrMissingCaptureIsNoPass) {
  const LimitTable limits = RecordLimits(TwoRungs(0.5, 0.05));
  Results refused = TwoRungs(0.5, 0.05);
  refused.devices[1].captures[0].refused = "no stripes";
  refused.devices[1].captures[0].figures.clear();
  EXPECT_EQ(Regressions(refused, limits).size(), 1U);
  refused.devices[1].captures.clear();
  EXPECT_EQ(Regressions(refused, limits).size(), 1U);
}

TEST(GuardTest, LimitsComeBackFromTheirFile) {
  const TempFolder folder;
  LimitTable limits;
  limits["a / b"]["z_rmse"].max = 0.0625;
  limits["a / b"]["sigma_ratio"] = {0.5, 1.5};
  ASSERT_TRUE(WriteLimits(folder / "limits.toml", "# two\n", limits).ok());
  const auto read = ReadLimits(folder / "limits.toml");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->at("a / b").at("z_rmse").max, 0.0625);
  EXPECT_FALSE(read->at("a / b").at("z_rmse").min);
  EXPECT_FALSE(read->at("a / b").at("sigma_ratio").Holds(0.4));
  EXPECT_TRUE(read->at("a / b").at("sigma_ratio").Holds(0.5));
  EXPECT_EQ(read->at("a / b").at("sigma_ratio").Text(), "0.5–1.5");
}

TEST(GuardTest, ALimitWithAMisspeltBoundIsRefused) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFile(folder / "limits.toml", "[a]\nz_rmse = { maximum = 1.0 }\n").ok());
  EXPECT_FALSE(ReadLimits(folder / "limits.toml").ok());
}

}  // namespace
}  // namespace dorsum::accuracy
