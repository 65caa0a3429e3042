// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_remove.h"

#include "jobs/campaign_disk.h"
#include "jobs/campaign_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CampaignRemoveTest : public CampaignFixture {};

TEST_F(CampaignRemoveTest, APersonLeavesNoTraceInAnyNameOrContent) {
  const std::string id = "subject-7f3a";
  const auto before = TreeOf(dir_);
  ASSERT_TRUE(Person(id, "woman", "60-69").ok());
  ASSERT_TRUE(Capture(1).ok());
  const auto others = TreeOf(dir_ / kPeopleFolder / "p01");
  ASSERT_TRUE(Capture(2, id).ok());
  ASSERT_TRUE(Capture(3, id, CampaignHand::kRight).ok());
  const std::string picture = *ReadFile(Folder(1, id) / "bgHand.png");
  ASSERT_TRUE(OccursIn(dir_, id) && OccursIn(dir_, Sha256Hex(picture)));
  const auto removed = RemoveFromCampaign({dir_, id, 0, {}}, {});
  ASSERT_TRUE(removed.ok()) << Why(removed);
  EXPECT_EQ(removed->captures, 2);
  for (const std::string& trace :
       {id, picture, Sha256Hex(picture), std::string("60-69"), std::string("woman")})
    EXPECT_FALSE(OccursIn(dir_, trace)) << trace.substr(0, 64);
  EXPECT_EQ(TreeOf(dir_ / kPeopleFolder / "p01"), others) << "the others are as they were";
  EXPECT_THAT(Findings(), IsEmpty());
  EXPECT_TRUE(Person(id).ok()) << "the id is free again";
}

TEST_F(CampaignRemoveTest, ACalibrationThatOnlyThePersonNeededGoesToo) {
  ASSERT_TRUE(Capture(1).ok());
  CampaignSession session = *ReadSession(dir_, "p01", 1);
  ASSERT_TRUE(MakeCampaignFolder(dir_ / kCalibrationsFolder).ok());
  for (const char* text : {"needed", "not needed"}) {
    ASSERT_TRUE(WriteDurably(CalibrationFile(dir_, Sha256Hex(text)), text).ok());
  }
  Campaign campaign = *ReadCampaign(dir_);
  campaign.calibration = Sha256Hex("needed");
  ASSERT_TRUE(WriteCampaign(dir_, campaign).ok());
  session.captures[0].calibration = Sha256Hex("not needed");
  ASSERT_TRUE(WriteSession(dir_, "p01", session).ok());
  ASSERT_TRUE(RemoveFromCampaign({dir_, "p01", 0, {}}, {}).ok());
  EXPECT_TRUE(fs::exists(CalibrationFile(dir_, Sha256Hex("needed"))));
  EXPECT_FALSE(fs::exists(CalibrationFile(dir_, Sha256Hex("not needed"))));
}

TEST_F(CampaignRemoveTest, ADamagedManifestKeepsNobodyFromBeingDeleted) {
  ASSERT_TRUE(Capture(1).ok());
  ASSERT_TRUE(Person("p02").ok());
  std::ofstream(SessionFolder(dir_, "p01", 1) / kSessionManifest) << "{";
  std::ofstream(PersonFolder(dir_, "p01") / kPersonJson) << "";
  EXPECT_TRUE(RemoveFromCampaign({dir_, "p01", 0, {}}, {}).ok());
  EXPECT_FALSE(OccursIn(dir_, "p01"));
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignRemoveTest, WhatIsNotThereIsSaidAndNothingElseGoes) {
  ASSERT_TRUE(Capture(1).ok());
  const auto before = TreeOf(dir_);
  EXPECT_THAT(Why(RemoveFromCampaign({dir_, "p02", 0, {}}, {})), HasSubstr("no person p02"));
  EXPECT_THAT(Why(RemoveFromCampaign({dir_, "../people/p01", 0, {}}, {})), HasSubstr("never a name"));
  EXPECT_THAT(Why(RemoveFromCampaign({dir_, "", 0, {}}, {})), HasSubstr("never a name"));
  const CaptureKey right{CampaignHand::kRight, 1}, second{CampaignHand::kLeft, 2};
  EXPECT_THAT(Why(RemoveFromCampaign({dir_, "p01", 1, right}, {})), HasSubstr("no right capture 1"));
  EXPECT_THAT(Why(RemoveFromCampaign({dir_, "p01", 1, second}, {})), HasSubstr("no left capture 2"));
  EXPECT_FALSE(RemoveFromCampaign({dir_, "p01", 2, right}, {}).ok());
  EXPECT_THAT(Why(RemoveFromCampaign({temp_ / "none", "p01", 0, {}}, {})), HasSubstr("no campaign"));
  EXPECT_FALSE(fs::exists(temp_ / "none"));
  EXPECT_EQ(TreeOf(dir_), before);
}

TEST_F(CampaignRemoveTest, ACaptureCanBeTakenAgain) {
  ASSERT_TRUE(Capture(1).ok());
  ASSERT_TRUE(Capture(2).ok());
  const CaptureKey first{CampaignHand::kLeft, 1};
  ASSERT_TRUE(RemoveFromCampaign({dir_, "p01", 1, first}, {}).ok());
  EXPECT_FALSE(fs::exists(Folder(1)));
  EXPECT_THAT(Findings(), IsEmpty());
  EXPECT_EQ(Capture(3)->capture.stored.number, 1) << "the free place is filled";
  EXPECT_EQ(Counted(), 2U);
}

}  // namespace
}  // namespace dorsum
