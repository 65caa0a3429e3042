// SPDX-License-Identifier: Apache-2.0
#include "accuracy/tables.h"

#include <gmock/gmock.h>

#include "accuracy/document.h"
#include "accuracy/document_tables.h"
#include "accuracy/plan.h"
#include "accuracy/rungs.h"
#include "accuracy/scene_kind.h"
#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum::accuracy {
namespace {

using testing::HasSubstr;

CaptureResult Box(const std::string& name, double rmse) {
  CaptureResult box;
  box.name = name;
  box.figures = {{"points", 100.0}, {"z_rmse", rmse}, {"z_rmse_laser0", rmse}, {"z_rmse_laser1", 2.0 * rmse}};
  box.budget = {{"total", rmse}, {"plane", 0.03}, {"fusion", 0.01}};
  for (const char* model : {"laser 0", "merged"}) {
    ModelErrors errors;
    errors.model = model;
    errors.rmse_mm = rmse;
    box.models.push_back(errors);
  }
  return box;
}

CaptureResult Refused(const std::string& name, const std::string& why) {
  CaptureResult capture;
  capture.name = name;
  capture.refused = why;
  return capture;
}

Results TwoBoxes() {
  DeviceResult device;
  device.design = "four lasers";
  device.seed = "s";
  device.rung = "classic";
  device.captures = {Box("box13.5", 0.04), Box("box25.5_r0", 0.08)};
  device.repeats = {{"box25.5_r0", "box25.5_r1", "merged", 0.002},
                    {"box25.5_r0", "box25.5_r2", "merged", 0.001},
                    {"box25.5_r1", "box25.5_r2", "merged", 0.004}};
  return {"test", {device}};
}

TEST(TablesTest, AcceptanceCountsCapturesThatMissAndTakesTheWorstLaser) {
  LimitTable asked;
  asked["four lasers / box"]["z_rmse"].max = 0.06;
  asked["four lasers / box"]["z_rmse_laser"].max = 0.2;
  asked["four lasers / box"]["repeat_difference"].max = 0.003;
  const std::string table = AcceptanceTable(TwoBoxes(), "four lasers", "four lasers", asked);
  EXPECT_THAT(table, HasSubstr("| box | `z_rmse` | ≤ 0.06 | 0.0600 | 0.0800 | **1 of 2** |"));
  EXPECT_THAT(table, HasSubstr("| box | `z_rmse_laser` | ≤ 0.2 | 0.1200 | 0.1600 | – |"));
  EXPECT_THAT(table, HasSubstr("| box | `repeat_difference` | ≤ 0.003 | 0.0023 | 0.0040 | **1 of 3** |"));
}

TEST(TablesTest, TheBudgetStandsBesideTheWhole) {
  EXPECT_THAT(BudgetTable(TwoBoxes(), "four lasers"), HasSubstr("| box | classic | 0.0632 | 0.0300 |"));
}

TEST(TablesTest, ARefusedCaptureShowsInEveryTable) {
  Results results = TwoBoxes();
  results.devices[0].captures[1] = Refused("box25.5_r0", "no stripes");
  LimitTable asked;
  asked["g / box"]["z_rmse"].max = 0.06;
  EXPECT_THAT(AcceptanceTable(results, "four lasers", "g", asked),
              HasSubstr("| box | refused | 0 | – | – | **1 of 2** |"));
  EXPECT_THAT(LadderTable(results, "four lasers"), HasSubstr("1 of 2 |"));
  EXPECT_THAT(CaptureTable(results, "four lasers", "classic"),
              HasSubstr("Refused: `box25.5_r0` of `s`: no stripes"));
}

TEST(TablesTest, TheDocumentsFiguresStandBesideOurs) {
  const std::string table = Table51(TwoBoxes(), "four lasers", "classic");
  EXPECT_THAT(table, HasSubstr("**Box 13.5 mm** (`box13.5`)"));
  EXPECT_THAT(table, HasSubstr("| merged | 0.0400 | 0.9114 |"));
  EXPECT_THAT(table, HasSubstr("| laser 0 | 0.0800 | 1.4558 |"));
  EXPECT_THAT(Table52(TwoBoxes(), "four lasers", "classic"), HasSubstr("| 2 and 3 | 0.0040 (0.0018) |"));
}

TEST(TablesTest, ResultsComeBackFromTheirFile) {
  const TempFolder folder;
  Results results = TwoBoxes();
  results.devices[0].captures.push_back(Refused("hand_x", "moved"));
  ASSERT_TRUE(WriteJson(folder / "results.json", ResultsToJson(results)).ok());
  const auto read = ReadResults(folder / "results.json");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(ResultsToJson(*read), ResultsToJson(results));
}

TEST(TablesTest, ATemplateIsFilledAndAnUnknownPlaceIsRefused) {
  const auto filled = FillTemplate("a {{x}} b\n", {{"x", "1\n\n"}});
  ASSERT_TRUE(filled.ok());
  EXPECT_EQ(*filled, "a 1 b\n");
  EXPECT_FALSE(FillTemplate("a {{y}}", {{"x", "1"}}).ok());
  EXPECT_FALSE(FillTemplate("a {{x", {{"x", "1"}}).ok());
}

TEST(TablesTest, ScenesAreToldByTheirFolders) {
  EXPECT_EQ(DescribeScene("box25.5_r2").kind, SceneKind::kBox);
  EXPECT_EQ(DescribeScene("box25.5_r2").size_mm, 25.5);
  EXPECT_EQ(DescribeScene("box25.5_r2").scene, "box25.5");
  EXPECT_EQ(DescribeScene("id02_R_k0").kind, SceneKind::kHand);
  EXPECT_EQ(DescribeScene("hand_man_left_q3_k1").kind, SceneKind::kHand);
  EXPECT_EQ(DescribeScene("plane_tilted").kind, SceneKind::kOther);
}

TEST(LadderTest, LeadsFromTheDocumentsMethodToTheDefault) {
  const std::vector<Rung> ladder = Ladder();
  EXPECT_EQ(ladder.front().options.mask, "classic");
  EXPECT_EQ(ladder.front().options.sheets, "plane");
  const ReconstructOptions defaults = ResolveStages({});
  EXPECT_EQ(ladder.back().options.mask, defaults.mask);
  EXPECT_EQ(ladder.back().options.stripes, defaults.stripes);
  EXPECT_EQ(ladder.back().options.indexing, defaults.indexing);
  EXPECT_EQ(ladder.back().options.sheets, defaults.sheets);
  EXPECT_EQ(ladder.back().options.correction, defaults.correction);
  EXPECT_EQ(ladder.back().options.fusion, defaults.fusion);
}

TEST(PlanTest, EveryDesignIsThereAndSeedsForTuningAreNotHeldOut) {
  const auto plan = ReadPlan("bench/accuracy/plan.toml");
  ASSERT_TRUE(plan.ok()) << plan.error().message;
  for (const DesignPlan& design : *plan) {
    EXPECT_TRUE(std::filesystem::exists(design.device)) << design.device;
    EXPECT_FALSE(design.held_out.empty()) << design.name;
  }
  const TempFolder folder;
  ASSERT_TRUE(
      WriteFile(folder / "plan.toml",
                "[[design]]\nname = \"a\"\ndevice = \"a.toml\"\ntuning = [\"1\"]\nheld_out = [\"1\"]\n"
                "scenes = []\n")
          .ok());
  EXPECT_FALSE(ReadPlan(folder / "plan.toml").ok());
}

}  // namespace
}  // namespace dorsum::accuracy
