// SPDX-License-Identifier: Apache-2.0
#include "speed/figures.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dorsum::speed {
namespace {

using ::testing::HasSubstr;

const Measured kRun = {{"floor", 2.0},
                       {"default/threads:1", 20.0},
                       {"default/threads:2", 12.0},
                       {"classic/threads:2", 60.0},
                       {"allocations", 0.0}};

const SpeedFigure& Find(const std::vector<SpeedFigure>& figures, const std::string& words) {
  for (const SpeedFigure& f : figures) {
    if (f.what.find(words) != std::string::npos) return f;
  }
  throw std::out_of_range(words);
}

TEST(SpeedFigures, AreRatiosOfOneRun) {
  const auto figures = FiguresOf(kRun);
  EXPECT_DOUBLE_EQ(Find(figures, "one-thread floor").reached, 6.0);
  EXPECT_TRUE(Find(figures, "one-thread floor").met);
  EXPECT_DOUBLE_EQ(Find(figures, "default one, 2 threads").reached, 5.0);
  EXPECT_FALSE(Find(figures, "default one, 2 threads").met);
  EXPECT_TRUE(Find(figures, "allocations").met);
  EXPECT_TRUE(std::isnan(Find(figures, "megapixel").reached));
  EXPECT_FALSE(Find(figures, "megapixel").met);
}

TEST(SpeedFigures, TablesSayWhatIsMissedAndWhatWasNotMeasured) {
  const std::string table = FigureTable(kRun);
  EXPECT_THAT(table, HasSubstr("| ≥ 10 | 5.00 | **missed** |"));
  EXPECT_THAT(table, HasSubstr("not measured"));
}

TEST(SpeedFigures, DetectorsStandBesideEachOther) {
  Measured run = kRun;
  run["steger/threads:1"] = 90.0;
  run["detector/threads:1"] = 6.0;
  run["points/object/ours/rms_px"] = 0.18;
  run["points/object/theirs/rms_px"] = 0.2;
  run["points/object/theirs/found"] = 0.97;
  const auto figures = FiguresOf(run);
  EXPECT_DOUBLE_EQ(Find(figures, "Steger over our detector, 1 thread").reached, 15.0);
  EXPECT_DOUBLE_EQ(Find(figures, "Steger's, the hand's").reached, 0.9);
  EXPECT_TRUE(Find(figures, "Steger's, the hand's").met);
  EXPECT_FALSE(Find(figures, "Steger finds").met);
  const std::string table = DetectorTable(run);
  EXPECT_THAT(table, HasSubstr("| OpenCV Steger | 45 | – | 97.0 % | 0.200 / – |"));
  EXPECT_THAT(table, HasSubstr("| our detector | 3.00 |"));
}

TEST(SpeedFigures, SizesAreRowsWithoutTheirStages) {
  Measured run = kRun;
  run["size/lasers:1"] = 8.0;
  run["size/lasers:1/mask"] = 1.0;
  const std::string table = SizeTable(run);
  EXPECT_THAT(table, HasSubstr("| 1 laser, 1.9 megapixels | 4.00 |"));
  EXPECT_THAT(table, ::testing::Not(HasSubstr("mask")));
}

TEST(SpeedFigures, SurviveTheirFile) {
  const auto back = MeasuredFromJson(MeasuredToJson(kRun), "x");
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(*back, kRun);
  EXPECT_FALSE(MeasuredFromJson(Json::parse("[1]"), "x").ok());
  EXPECT_FALSE(MeasuredFromJson({{"schema", "dorsum/speed"}, {"measured", {{"floor", "fast"}}}}, "x").ok());
}

}  // namespace
}  // namespace dorsum::speed
