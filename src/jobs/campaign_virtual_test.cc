// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_virtual.h"

#include <atomic>

#include "jobs/campaign_fixture_test.h"
#include "jobs/campaign_remove.h"
#include "jobs/campaign_status.h"
#include "jobs/reconstruct_batch.h"
#include "jobs/scan_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// One virtual person before the small device of the other tests, which is calibrated already.
class CampaignVirtualTest : public ::testing::Test {
 protected:
  CampaignVirtualTest() {
    request_.dir = temp_ / "virtual";
    request_.plan.people = 1;
    request_.plan.hands = {CampaignHand::kRight};
    request_.seed = ScanFixture::kSeed;
    request_.device = ScanFixture::Scan() / "device.toml";
    request_.calibration = ScanFixture::CalibrationJson();
  }
  TempFolder temp_;
  VirtualCampaignRequest request_;
};

TEST_F(CampaignVirtualTest, GoesOnAfterAnInterruptWithThePicturesThatSimulateMakes) {
  std::atomic<bool> cancel{false};
  Context context;
  context.cancel = &cancel;
  context.progress = [&](std::string_view stage, double) { cancel = stage == "capture id00_R_k0"; };
  const auto first = MakeVirtualCampaign(request_, context);
  ASSERT_FALSE(first.ok());
  EXPECT_EQ(first.error().code, ErrorCode::kCancelled);
  EXPECT_EQ(ListCaptures(request_.dir)->size(), 0U);
  EXPECT_THAT(VerifyCampaign(request_.dir, {})->findings, IsEmpty());

  const auto second = MakeVirtualCampaign(request_, {});
  ASSERT_TRUE(second.ok()) << Why(second);
  EXPECT_EQ(second->captures, 1);
  EXPECT_EQ(second->made, 1);
  EXPECT_EQ(MakeVirtualCampaign(request_, {})->made, 0);
  EXPECT_THAT(VerifyCampaign(request_.dir, {})->findings, IsEmpty());
  EXPECT_TRUE(ReadPerson(request_.dir, "id00")->is_virtual);

  SimulateOptions simulate;
  simulate.device_path = request_.device;
  simulate.seed = request_.seed;
  simulate.population = 1;
  simulate.calibration = false;
  ASSERT_TRUE(Simulate(simulate, temp_ / "scan", {}).ok());
  for (const char* name : {"bgHand.png", "stripesHand0.png", "stripesHand2.png"}) {
    const fs::path stored = CaptureFolder(request_.dir, "id00", 1, {CampaignHand::kRight, 1}) / name;
    EXPECT_EQ(*ReadFile(stored), *ReadFile(temp_ / "scan" / "captures" / "id00_R_k0" / name)) << name;
  }

  // The whole way to surfaces and their quality, each capture with its own calibration.
  ReconstructRequest batch;
  batch.capture_dir = request_.dir;
  batch.out_dir = request_.dir / "surfaces";
  batch.report = false;
  EXPECT_THAT(Why(ReconstructBatch(batch, {})), HasSubstr("would lie in the campaign"));
  batch.out_dir = temp_ / "surfaces";
  const auto surfaces = ReconstructBatch(batch, {});
  ASSERT_TRUE(surfaces.ok()) << Why(surfaces);
  EXPECT_EQ(surfaces->Count(BatchOutcome::kDone), 1);
  const auto status = StatusOfCampaign(request_.dir, batch.out_dir, {});
  ASSERT_TRUE(status.ok()) << Why(status);
  EXPECT_EQ(status->quality->reconstructed, 1);
  EXPECT_GT(status->quality->least_points, 1000U);
  EXPECT_EQ(status->without_calibration, 0);
  EXPECT_EQ(ReconstructBatch(batch, {})->Count(BatchOutcome::kKept), 1);
}

TEST_F(CampaignVirtualTest, AnotherCampaignInTheFolderIsNotContinued) {
  std::atomic<bool> cancel{false};
  Context context;
  context.cancel = &cancel;
  context.progress = [&](std::string_view stage, double) { cancel = stage == "capture id00_R_k0"; };
  ASSERT_FALSE(MakeVirtualCampaign(request_, context).ok());
  const auto before = TreeOf(request_.dir);
  VirtualCampaignRequest other = request_;
  other.seed = "2";
  EXPECT_THAT(Why(MakeVirtualCampaign(other, {})), HasSubstr("another one than asked for"));
  other = request_;
  other.plan.captures = 2;
  EXPECT_THAT(Why(MakeVirtualCampaign(other, {})), HasSubstr("another one than asked for"));
  other = request_;
  other.device.clear();
  EXPECT_THAT(Why(MakeVirtualCampaign(other, {})), HasSubstr("another one than asked for"));
  other.plan.people = 0;
  EXPECT_THAT(Why(MakeVirtualCampaign(other, {})), HasSubstr("1 to 10000 people"));
  const AddPersonRequest real{
      request_.dir, {"p01", "man", "20-29", "2024-01-01", false}, false, "2024-06-01"};
  EXPECT_THAT(Why(AddPerson(real, {})), HasSubstr("virtual people"));
  EXPECT_EQ(TreeOf(request_.dir), before);
}

}  // namespace
}  // namespace dorsum
