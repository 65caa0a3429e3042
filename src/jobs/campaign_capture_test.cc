// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_capture.h"

#include "jobs/campaign_fixture_test.h"
#include "jobs/virtual_device_test.h"

namespace dorsum {
namespace {

// The same pictures twice are refused, so the virtual hand may not come as it came before.
TEST_F(CampaignFixture, AVirtualHandComesAnotherWayToEachCapture) {
  Device device = OpenFixtureDevice(temp_);
  std::vector<std::string> warnings;
  for (int number = 1; number <= 2; ++number) {
    const AddCaptureRequest request = Wanted();
    const auto added = AddCapture(request, CaptureWithDevice(&device, request, &warnings), {});
    ASSERT_TRUE(added.ok()) << added.error().message;
    EXPECT_EQ(added->capture.stored.number, number);
  }
  EXPECT_NE(*ReadFile(Folder(1) / "bgHand.png"), *ReadFile(Folder(2) / "bgHand.png"));
  EXPECT_THAT(Findings(), ::testing::IsEmpty());
  const AddCaptureRequest third = Wanted();
  EXPECT_FALSE(AddCapture(third, CaptureWithDevice(&device, third, &warnings), {}).ok()) << "not planned";
}

}  // namespace
}  // namespace dorsum
