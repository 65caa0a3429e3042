// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_names.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(CampaignNamesTest, IdsThatAreNamesPathsOrTooLongAreRefused) {
  for (const char* id : {"p01", "7", "A-3_b", "0123456789abcdefghijklmnopqrstuv"}) {
    EXPECT_TRUE(CheckPersonId(id).ok()) << id;
  }
  const std::vector<std::string> bad = {"",
                                        "anna",
                                        "../p1",
                                        "..",
                                        ".p1",
                                        "p1/",
                                        "p1/../p2",
                                        "/p1",
                                        "p 1",
                                        "p1\n",
                                        "p1\xc3\xa4",
                                        "-p1",
                                        "_1",
                                        "p1.",
                                        "C:1",
                                        "p1\\2",
                                        "1\xff",
                                        "p*1",
                                        "p1;rm",
                                        std::string("p1\0", 3),
                                        std::string("p1\0x", 4),
                                        std::string(33, '1'),
                                        std::string(10240, '1')};
  for (const std::string& id : bad) {
    const Status status = CheckPersonId(id);
    ASSERT_FALSE(status.ok()) << id;
    EXPECT_EQ(status.error().code, ErrorCode::kUsage);
    EXPECT_LT(status.error().message.size(), 300U) << "the id's own text is not repeated";
  }
}

TEST(CampaignNamesTest, ConsentOnADayThatIsNoneOrNotYetIsRefused) {
  const std::string today = "2024-06-01";
  for (const char* date : {"2024-06-01", "2024-02-29", "1990-01-01", "2023-12-31"}) {
    EXPECT_TRUE(CheckConsentDate(date, today).ok()) << date;
  }
  for (const char* date : {"", "2024-06-02", "2025-01-01", "2023-02-29", "2024-00-10", "2024-13-01",
                           "2024-04-31", "2024-4-3", "31.05.2024", "2024-05-31 ", " 2024-05-3", "20240531",
                           "1989-12-31", "2024/05/31", "-024-05-31", "2024-05-3x", "0000-00-00"}) {
    EXPECT_FALSE(CheckConsentDate(date, today).ok()) << date;
  }
  EXPECT_TRUE(CheckConsentDate(Today(), Today()).ok()) << Today();
}

TEST(CampaignNamesTest, OnlyPicturesOfACaptureHavePictureNames) {
  for (const char* name : {"bgHand.png", "bgHandAfter.jpg", "stripesHand0.png", "stripesHand7.jpg"}) {
    EXPECT_TRUE(IsPictureName(name)) << name;
  }
  for (const char* name : {"", "bgHand", "stripesHand8.png", "../bgHand.png", "bgHand.png/", "bgHand.PNG",
                           "notes.txt", "bgHand.jpeg"}) {
    EXPECT_FALSE(IsPictureName(name)) << name;
  }
}

}  // namespace
}  // namespace dorsum
