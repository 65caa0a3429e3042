// SPDX-License-Identifier: Apache-2.0
#include "simulator/truth_files.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "accuracy/capture_truth.h"
#include "accuracy/statistics.h"
#include "accuracy/stripe_table.h"
#include "base/random.h"
#include "base/temp_folder_test.h"
#include "simulator/capture_writer.h"
#include "simulator/named_scene.h"
#include "simulator/small_device_test.h"
#include "simulator/truth.h"

namespace dorsum::accuracy {
namespace {

// What the virtual device writes must come back as it was: else every figure of the bench is off by a frame
// or half a pixel.
TEST(TruthFilesTest, TheVirtualDevicesTruthIsReadBack) {
  const TempFolder folder;
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(160), NamedSeed("truth"));
  const auto name = ParseSceneName("box25.5");
  ASSERT_TRUE(name.ok());
  const auto stage = SetStage(device, BuildNamedScene(device, *name, device.seed, device.seed), {});
  ASSERT_TRUE(stage.ok());
  std::filesystem::create_directories(folder / "truth/box");
  ASSERT_TRUE(WriteSurfaceTruth(*stage, folder / "truth/box").ok());
  for (int k = 0; k < static_cast<int>(device.lasers.size()); ++k) {
    ASSERT_TRUE(WriteStripeTruth(device, *stage, k, folder / "truth/box", {}).ok());
  }
  ASSERT_TRUE(WriteJson(folder / "truth/device.json", DeviceToJson(device)).ok());

  const auto truth = ReadCaptureTruth(folder / "truth/box", folder / "truth/device.json");
  ASSERT_TRUE(truth.ok()) << truth.error().message;
  EXPECT_EQ(truth->lasers.size(), device.lasers.size());
  const int u = 80, v = 60;
  const SurfaceSample& sample = stage->view.At(u, v);
  EXPECT_NEAR(sample.position.z(), 25.5, 1e-6);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(truth->xyz(v, u)[i], sample.position[i], 2e-3);
  EXPECT_NEAR(TruthAt(*truth, u + 0.3, v + 0.6, 1.5)[2], 25.5, 2e-3);
  EXPECT_TRUE(std::isnan(TruthAt(*truth, 1.0, 1.0, 1.5)[2]));  // backplane
  const auto stripes = TrueStripes(device, *stage, 0, {});
  ASSERT_TRUE(stripes.ok());
  ASSERT_EQ(truth->lasers.at(0).size(), stripes->size());
  for (std::size_t i = 0; i < stripes->size(); ++i) {
    EXPECT_EQ(truth->lasers.at(0)[i].order, (*stripes)[i].order);
    EXPECT_NEAR(truth->lasers.at(0)[i].u, (*stripes)[i].u, 1e-6);
  }
}

TEST(TruthFilesTest, PlainTablesWithOtherColumnsAndNoLastNewlineAreRead) {
  const TempFolder folder;
  std::ofstream(folder / "stripes0.csv") << "irradiance,extra,order,v,u,z,material\n0.5,9,-3,7,12.25,1.5,4";
  const auto stripes = ReadStripeTable(folder / "stripes0.csv");
  ASSERT_TRUE(stripes.ok()) << stripes.error().message;
  ASSERT_EQ(stripes->size(), 1U);
  EXPECT_EQ(stripes->front().order, -3);
  EXPECT_EQ(stripes->front().row, 7);
  EXPECT_EQ(stripes->front().u, 12.25);
  EXPECT_EQ(stripes->front().irradiance, 0.5);
}

TEST(TruthFilesTest, DamagedTablesAreRefused) {
  const TempFolder folder;
  std::ofstream(folder / "a.csv") << "order,v,u,z,material\n1,2,3,4,5\n";
  std::ofstream(folder / "b.csv") << "order,v,u,z,material,irradiance\n1,2,3,x,5,6\n";
  EXPECT_FALSE(ReadStripeTable(folder / "a.csv").ok());
  EXPECT_FALSE(ReadStripeTable(folder / "b.csv").ok());
  EXPECT_FALSE(ReadStripeTable(folder / "missing.csv").ok());
}

TEST(StatisticsTest, QuantilesRunStraightBetweenRanks) {
  EXPECT_DOUBLE_EQ(Quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(Quantile({4.0, 1.0, 3.0, 2.0}, 0.95), 3.85);
  EXPECT_DOUBLE_EQ(Quantile({7.0}, 0.95), 7.0);
  const ErrorStatistics s = Describe({-3.0, 1.0, 1.0, -1.0});
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(s.bias, -0.5);
  EXPECT_DOUBLE_EQ(s.median_abs, 1.0);
}

}  // namespace
}  // namespace dorsum::accuracy
