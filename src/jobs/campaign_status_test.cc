// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_status.h"

#include "jobs/campaign_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pair;
using ::testing::SizeIs;

class CampaignStatusTest : public CampaignFixture {
 protected:
  CampaignStatus Status(const fs::path& surfaces = {}) {
    const auto status = StatusOfCampaign(dir_, surfaces, {});
    EXPECT_TRUE(status.ok()) << Why(status);
    return status.ok() ? *status : CampaignStatus{};
  }
};

TEST_F(CampaignStatusTest, PeopleHandsAndGapsAreCounted) {
  ASSERT_TRUE(Person("p02", "woman", "30-39").ok());
  ASSERT_TRUE(Person("p03").ok());
  for (const int seed : {1, 2}) ASSERT_TRUE(Capture(seed).ok());
  ASSERT_TRUE(Capture(3, "p02", CampaignHand::kRight).ok());
  ASSERT_TRUE(AddCapture(Wanted("p02"), Noise(4, 1), {}).ok());
  const CampaignStatus s = Status();
  EXPECT_EQ(s.people, 3);
  EXPECT_EQ(s.complete, 0);
  EXPECT_THAT(s.sexes, ElementsAre(Pair("man", 2), Pair("woman", 1)));
  EXPECT_THAT(s.age_groups, ElementsAre(Pair("20-29", 2), Pair("30-39", 1)));
  EXPECT_EQ(s.hands, 3);
  EXPECT_EQ(s.sessions, 2);
  EXPECT_EQ(s.captures, 4);
  EXPECT_EQ(s.planned_captures, 3 * 2 * 2 * 2);
  EXPECT_EQ(s.lacking_laser, 1);
  EXPECT_EQ(s.without_calibration, 4);
  ASSERT_THAT(s.missing, SizeIs(3 + 4 + 4));
  EXPECT_EQ(s.missing[0].id, "p01");
  EXPECT_EQ(s.missing[0].hand, CampaignHand::kRight);
  EXPECT_EQ(s.missing[0].count, 2);
  const std::string text = StatusToText(s);
  for (const char* part :
       {"2 men, 1 woman", "2 20-29, 1 30-39", "4 of 24, 1 lacking a laser", "p01, session 1, right: 2"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(text, Not(HasSubstr("surfaces"))) << "nobody reconstructed anything";
  const Json json = StatusToJson(s);
  EXPECT_EQ(json["sexes"]["man"], 2);
  EXPECT_EQ(json["missing"].size(), 11U);
  EXPECT_FALSE(json.contains("quality"));
}

TEST_F(CampaignStatusTest, APersonWithAllCapturesIsComplete) {
  int seed = 0;
  for (const int session : {1, 2}) {
    for (const CampaignHand hand :
         {CampaignHand::kLeft, CampaignHand::kRight, CampaignHand::kLeft, CampaignHand::kRight}) {
      AddCaptureRequest request = Wanted("p01", hand);
      request.session = session;
      ASSERT_TRUE(AddCapture(request, Noise(++seed), {}).ok());
    }
  }
  const CampaignStatus s = Status();
  EXPECT_EQ(s.complete, 1);
  EXPECT_THAT(s.missing, SizeIs(0));
  EXPECT_EQ(s.captures, s.planned_captures);
}

TEST_F(CampaignStatusTest, WhatCannotBeReadIsToldAndNotCounted) {
  ASSERT_TRUE(Person("p02").ok());
  ASSERT_TRUE(Capture(1).ok());
  ASSERT_TRUE(Capture(2, "p02").ok());
  std::ofstream(SessionFolder(dir_, "p02", 1) / kSessionManifest) << "{";
  const CampaignStatus s = Status();
  EXPECT_EQ(s.captures, 1);
  EXPECT_THAT(s.problems, ElementsAre(HasSubstr("manifest.json")));
  EXPECT_THAT(StatusToText(s), HasSubstr("problem"));
  std::ofstream(dir_ / kCampaignJson) << "{";
  EXPECT_THAT(Why(StatusOfCampaign(dir_, {}, {})), HasSubstr("campaign.json"));
}

TEST_F(CampaignStatusTest, QualityIsWhatABatchFound) {
  for (const int seed : {1, 2}) ASSERT_TRUE(Capture(seed).ok());
  ASSERT_TRUE(Capture(3, "p01", CampaignHand::kRight).ok());
  const fs::path out = temp_ / "surfaces";
  fs::create_directories(out / "p01_s1_left_k1");
  std::ofstream(out / "summary.csv") << "capture,result,points,triangles,error,warnings\n"
                                        "p01_s1_left_k1,kept,500,9,,\n"
                                        "p01_s1_left_k2,failed,,,\"no hand, or\ntwo\",\n"
                                        "someone_else,done,1,1,,\n";
  std::ofstream(out / "p01_s1_left_k1" / "report.json") << R"({"points": 500, "warnings": ["dark"]})";
  const CampaignStatus s = Status(out);
  ASSERT_TRUE(s.quality.has_value());
  EXPECT_EQ(s.quality->reconstructed, 1);
  EXPECT_EQ(s.quality->failed, 1);
  EXPECT_EQ(s.quality->not_tried, 1);
  EXPECT_EQ(s.quality->with_warnings, 1);
  EXPECT_EQ(s.quality->median_points, 500U);
  EXPECT_THAT(s.quality->failures, ElementsAre("p01_s1_left_k2"));
  EXPECT_THAT(StatusToText(s), HasSubstr("1 of 2 captures that were tried"));
  EXPECT_EQ(StatusToJson(s)["quality"]["failed"], 1);
  for (const char* bad :
       {"[]", "{", R"({"points": -1, "warnings": []})", R"({"points": 1, "warnings": 3})"}) {
    std::ofstream(out / "p01_s1_left_k1" / "report.json") << bad;
    EXPECT_FALSE(StatusOfCampaign(dir_, out, {}).ok()) << bad;
  }
  EXPECT_THAT(Why(StatusOfCampaign(dir_, temp_ / "none", {})), HasSubstr("summary.csv"));
}

}  // namespace
}  // namespace dorsum
