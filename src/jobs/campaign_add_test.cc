// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_add.h"

#include "jobs/campaign_disk.h"
#include "jobs/campaign_fixture_test.h"
#include "jobs/scan_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CampaignAddTest : public CampaignFixture {};

TEST_F(CampaignAddTest, ACampaignIsNotMadeWhereSomethingIs) {
  CreateCampaignRequest request{dir_, "", {}, {}, {}};
  ExpectRefused([&] { return CreateCampaign(request, {}); }, "is a campaign already");
  request.dir = temp_.path();
  ExpectRefused([&] { return CreateCampaign(request, {}); }, "not an empty folder");
  request.dir = dir_ / kCampaignJson;
  ExpectRefused([&] { return CreateCampaign(request, {}); }, "not an empty folder");
  request.dir = "/proc/study";
  ExpectRefused([&] { return CreateCampaign(request, {}); }, "cannot write");
  request.dir = temp_ / "other";
  request.plan.captures = 101;
  ExpectRefused([&] { return CreateCampaign(request, {}); }, "1 to 100 captures");
  request.plan.captures = 1;
  request.name = "two\nlines";
  ExpectRefused([&] { return CreateCampaign(request, {}); }, "printable");
  EXPECT_FALSE(fs::exists(request.dir));
  EXPECT_EQ(fs::status(dir_).permissions(), fs::perms::owner_all) << "others may not look";
}

TEST_F(CampaignAddTest, WithoutConsentNothingIsStored) {
  const auto add = [&](const std::string& consent) {
    return [this, consent] {
      return AddPerson({dir_, {"p02", "man", "20-29", consent, false}, false, "2024-06-01"}, {});
    };
  };
  ExpectRefused(add(""), "without consent nothing is stored");
  ExpectRefused(add("2024-06-02"), "future");
  ExpectRefused(add("yesterday"), "a day that exists");
  ExpectRefused([&] { return Capture(1, "p02"); }, "no person p02");
  EXPECT_TRUE(add("2024-06-01")().ok());
}

TEST_F(CampaignAddTest, PeopleWhoCannotBeAreRefused) {
  ExpectRefused([&] { return Person("p01"); }, "a person p01");
  ExpectRefused([&] { return Person("P01"); }, "a person p01");
  ExpectRefused([&] { return Person("../p02"); }, "never a name");
  ExpectRefused([&] { return Person("p02", "girl"); }, "man, woman");
  ExpectRefused([&] { return Person("p02", "man", "25"); }, "20-29");
  const AddPersonRequest virtual_person{dir_, {"p02", "man", "20-29", "", true}, false, "2024-06-01"};
  ExpectRefused([&] { return AddPerson(virtual_person, {}); }, "real people");
}

TEST_F(CampaignAddTest, WhatWasSaidWronglyCanBeCorrected) {
  AddPersonRequest request{dir_, {"p01", "woman", "30-39", "2024-05-30", false}, true, "2024-06-01"};
  ASSERT_TRUE(AddPerson(request, {}).ok());
  EXPECT_EQ(ReadPerson(dir_, "p01")->sex, "woman");
  EXPECT_THAT(Findings(), IsEmpty());
  request.person.id = "p02";
  ExpectRefused([&] { return AddPerson(request, {}); }, "to correct");
}

TEST_F(CampaignAddTest, CapturesAreNumberedByHandAndSessionUpToThePlan) {
  EXPECT_EQ(Capture(1)->capture.Name(), "p01_s1_left_k1");
  EXPECT_EQ(Capture(2)->capture.Name(), "p01_s1_left_k2");
  EXPECT_EQ(Capture(3, "p01", CampaignHand::kRight)->capture.Name(), "p01_s1_right_k1");
  ExpectRefused([&] { return Capture(4); }, "--session");
  AddCaptureRequest next = Wanted();
  next.session = 2;
  EXPECT_EQ(AddCapture(next, Noise(4), {})->capture.Name(), "p01_s2_left_k1");
  EXPECT_EQ(Capture(5)->capture.Name(), "p01_s2_left_k2") << "the last session goes on";
  for (const int session : {0, 3, -1}) {
    next.session = session;
    ExpectRefused([&] { return AddCapture(next, Noise(6), {}); }, "sessions 1 to 2");
  }
  EXPECT_EQ(Counted(), 5U);
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignAddTest, AnImportTakesThePicturesAndNothingElse) {
  WriteNoiseCapture(temp_ / "source", 1);
  fs::rename(temp_ / "source" / "bgHand.png", temp_ / "source" / "bgHand.JPEG");  // a PNG all the same
  std::ofstream(temp_ / "source" / "notes.txt") << "Anna was late";
  fs::create_directories(temp_ / "source" / "more");
  const auto added = AddCapture(Wanted(), ImportCapture(temp_ / "source"), {});
  ASSERT_TRUE(added.ok()) << Why(added);
  std::vector<std::string> names = *NamesIn(Folder());
  EXPECT_THAT(names, ElementsAre("bgHand.png", "stripesHand0.png", "stripesHand1.png"));
  EXPECT_EQ(*ReadFile(Folder() / "bgHand.png"), *ReadFile(temp_ / "source" / "bgHand.JPEG"));
  EXPECT_FALSE(OccursIn(dir_, "Anna"));
  EXPECT_TRUE(fs::exists(temp_ / "source" / "notes.txt"));
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignAddTest, CapturesThatAreNotWholeAreRefusedInTheSourcesName) {
  const auto import = [&] { return AddCapture(Wanted(), ImportCapture(temp_ / "source"), {}); };
  ExpectRefused(import, "no capture folder");
  fs::create_directories(temp_ / "source");
  ExpectRefused(import, "bgHand (.jpg or .png) is missing in SOURCE");
  WriteNoiseCapture(temp_ / "source", 1, 0);
  ExpectRefused(import, "no image stripesHand0, stripesHand1, … in SOURCE");
  WriteNoiseCapture(temp_ / "source", 1);
  fs::resize_file(temp_ / "source" / "stripesHand1.png", 300);
  ExpectRefused(import, "SOURCE/stripesHand1.png is cut off");
  cv::imwrite((temp_ / "source" / "stripesHand1.png").string(), cv::Mat::zeros(24, 32, CV_8UC3));
  ExpectRefused(import, "SOURCE/stripesHand1.png is black");
  ExpectRefused([&] { return AddCapture(Wanted(), [](auto&&...) { return Status(); }, {}); }, "SOURCE");
}

TEST_F(CampaignAddTest, AnotherDevicesPicturesAreRefused) {
  ASSERT_TRUE(Capture(1).ok());
  ExpectRefused([&] { return AddCapture(Wanted(), Noise(2, 2, {40, 30}), {}); }, "32x24 is expected");
  ExpectRefused([&] { return AddCapture(Wanted(), Noise(2, 3), {}); }, "laser 2");
  const fs::path other = ScanFixture::CalibrationJson();  // of a camera with more pixels
  AddCaptureRequest request = Wanted();
  request.calibration = other;
  ExpectRefused([&] { return AddCapture(request, Noise(2), {}); }, "a campaign has one device");
  const auto lacking = AddCapture(Wanted(), Noise(2, 1), {});
  ASSERT_TRUE(lacking.ok());
  EXPECT_THAT(lacking->warnings[0], HasSubstr("no picture of laser 1 in SOURCE"));
}

TEST_F(CampaignAddTest, TheSamePicturesTwiceAreRefused) {
  ASSERT_TRUE(Capture(1).ok());
  ASSERT_TRUE(Person("p02").ok());
  ExpectRefused([&] { return Capture(1); }, "add each capture once");
  ExpectRefused([&] { return Capture(1, "p02"); }, Folder().string());
}

TEST_F(CampaignAddTest, ACalibrationIsStoredOnceForAllItsCaptures) {
  const fs::path calibration = ScanFixture::CalibrationJson();
  CreateCampaignRequest fresh{temp_ / "scan", "", {}, {}, {}};
  fresh.plan.captures = 2;
  ASSERT_TRUE(CreateCampaign(fresh, {}).ok());
  dir_ = fresh.dir;
  ASSERT_TRUE(Person("p01").ok());
  AddCaptureRequest request = Wanted();
  request.calibration = calibration;
  ASSERT_TRUE(AddCapture(request, Noise(1, 3, {560, 420}), {}).ok());
  const auto second = AddCapture(Wanted(), Noise(2, 3, {560, 420}), {});
  ASSERT_TRUE(second.ok()) << Why(second);
  EXPECT_THAT(second->warnings, IsEmpty());
  EXPECT_EQ(second->capture.stored.calibration, Sha256Hex(*ReadFile(calibration)));
  EXPECT_EQ(NamesIn(dir_ / kCalibrationsFolder)->size(), 1U);
  EXPECT_EQ(*ReadFile(**PresentCalibration(dir_)), *ReadFile(calibration));
  EXPECT_THAT(Findings(), IsEmpty());
}

}  // namespace
}  // namespace dorsum
