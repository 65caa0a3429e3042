// SPDX-License-Identifier: Apache-2.0
#include "captures/series_plan.h"

#include <set>

#include <gtest/gtest.h>

#include "captures/names.h"

namespace dorsum {
namespace {

std::set<std::string> NamesOf(const std::vector<SeriesStep>& plan) {
  std::set<std::string> names;
  for (const SeriesStep& step : plan) {
    for (const SeriesPicture& picture : step.pictures) EXPECT_TRUE(names.insert(picture.name).second);
  }
  return names;
}

TEST(SeriesPlan, EveryPictureOfTheFolderIsPlannedOnce) {
  const DeviceDescription device = DefaultDevice();
  const std::set<std::string> names = NamesOf(PlanCalibrationSeries(device));
  EXPECT_EQ(names.size(), 12U + 2U + 2U + 4U * 5U + 5U * 5U);
  for (const char* name : {"chess00", "chess11", "laserCalFurtherBg", "laserCalCloserBg", "bgNoHand",
                           "laserFirstEstimates", "stripesBg3", "laser2CalFurther", "laser0CalCloserChess",
                           "heights/h10.0/bgHand", "heights/h50.0/stripesHand3"}) {
    EXPECT_EQ(names.count(name), 1U) << name;
  }
}

TEST(SeriesPlan, ADeviceWithOneLaserAndNoBoxesHasAPlan) {
  DeviceDescription device = DefaultDevice();
  device.lasers.resize(1);
  device.box_heights_mm.clear();
  const std::vector<SeriesStep> plan = PlanCalibrationSeries(device);
  EXPECT_EQ(NamesOf(plan).size(), 12U + 2U + 2U + 5U);
  EXPECT_NE(InstructionOf(plan.front(), device).find("laser 0"), std::string::npos);
}

TEST(SeriesPlan, EveryStepSaysWhatToDo) {
  const DeviceDescription device = DefaultDevice();
  for (const SeriesStep& step : PlanCalibrationSeries(device)) {
    EXPECT_FALSE(InstructionOf(step, device).empty());
    EXPECT_FALSE(step.pictures.empty());
  }
}

TEST(SeriesPlan, TheSetupIsThatOfTheDevice) {
  const DeviceDescription device = DefaultDevice();
  const dorsum::Setup setup = SetupOf(device);
  EXPECT_EQ(setup.board_columns, 11);
  EXPECT_EQ(setup.width, 1600);
  EXPECT_EQ(setup.box_heights_mm.size(), 5U);
  EXPECT_EQ(setup.grating_lines_per_mm, 100.0);
}

}  // namespace
}  // namespace dorsum
