// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_export.h"

#include <atomic>

#include "base/json.h"
#include "captures/capture.h"
#include "captures/image_file.h"
#include "jobs/campaign_export_people.h"
#include "jobs/campaign_fixture_test.h"
#include "jobs/scan_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CampaignExportTest : public CampaignFixture {
 protected:
  CampaignExportTest() {
    EXPECT_TRUE(Person("subject-7f3a", "woman", "60-69").ok());
    EXPECT_TRUE(Capture(1).ok());
    EXPECT_TRUE(Capture(2, "subject-7f3a").ok());
  }
  const fs::path out_ = temp_ / "out";
};

TEST_F(CampaignExportTest, NoIdSexAgeConsentNameOrTimeIsInIt) {
  const auto exported = ExportCampaign({dir_, out_, false, 5}, {});
  ASSERT_TRUE(exported.ok()) << Why(exported);
  EXPECT_EQ(exported->people, 2);
  EXPECT_EQ(exported->captures, 2);
  for (const char* trace : {"p01", "subject", "7f3a", "woman", "\"man", "60-69", "20-29", "2024", "consent",
                            "study", "under-40", "over-59"}) {
    EXPECT_FALSE(OccursIn(out_, trace)) << trace;
  }
  for (const auto& entry : fs::recursive_directory_iterator(out_)) {
    EXPECT_EQ(fs::last_write_time(entry), fs::last_write_time(out_)) << entry.path();
  }
  const Json json = *ReadJson(out_ / "export.json");
  ASSERT_EQ(json["people"].size(), 2U);
  EXPECT_LT(json["people"][0]["id"].get<std::string>(), json["people"][1]["id"].get<std::string>());
  EXPECT_EQ(json["people"][0].size(), 1U);
  for (const Json& capture : json["captures"]) {
    const fs::path folder = out_ / "captures" / capture["name"].get<std::string>();
    EXPECT_TRUE(LoadCapture(folder, {32, 24}, {0, 1}).ok());
  }
  const auto again = ExportCampaign({dir_, temp_ / "again", false, 5}, {});
  ASSERT_TRUE(again.ok());
  EXPECT_FALSE(OccursIn(temp_ / "again", json["people"][0]["id"])) << "the ids are new each time";
}

TEST_F(CampaignExportTest, PicturesKeepTheirPixelsAndLoseWhatElseTheyHold) {
  WriteNoiseCapture(temp_ / "source", 7, 2, {32, 24}, ".jpg");
  const fs::path picture = temp_ / "source" / "bgHand.jpg";
  std::string bytes = *ReadFile(picture);
  bytes.insert(2, std::string("\xff\xe1\x00\x10"
                              "Exif\0\0 49.19 N",
                              18));
  std::ofstream(picture, std::ios::binary) << bytes;
  ASSERT_TRUE(AddCapture(Wanted(), ImportCapture(temp_ / "source"), {}).ok());
  ASSERT_TRUE(OccursIn(dir_, "49.19 N"));
  ASSERT_TRUE(ExportCampaign({dir_, out_, false, 5}, {}).ok());
  EXPECT_FALSE(OccursIn(out_, "49.19 N"));
  EXPECT_FALSE(OccursIn(out_, "Exif"));
  for (const auto& entry : fs::recursive_directory_iterator(out_)) {
    if (entry.path().filename() != "bgHand.jpg") continue;
    EXPECT_EQ(cv::norm(*ReadImage(entry.path()), *ReadImage(picture), cv::NORM_INF), 0.0);
  }
}

TEST_F(CampaignExportTest, CalibrationsLoseTheirFileNamesAndStillCalibrate) {
  dir_ = temp_ / "scan";
  CreateCampaignRequest request{dir_, "", {}, {}, ScanFixture::CalibrationJson()};
  ASSERT_TRUE(CreateCampaign(request, {}).ok());
  ASSERT_TRUE(Person("p01").ok());
  ASSERT_TRUE(AddCapture(Wanted(), Noise(1, 3, {560, 420}), {}).ok());
  ASSERT_TRUE(OccursIn(dir_, "chess00"));
  ASSERT_TRUE(ExportCampaign({dir_, out_, false, 5}, {}).ok());
  EXPECT_FALSE(OccursIn(out_, "chess00"));
  const Json json = *ReadJson(out_ / "export.json");
  const std::string hash = json["captures"][0]["calibration"];
  const fs::path file = out_ / kCalibrationsFolder / (hash + ".json");
  EXPECT_EQ(Sha256Hex(*ReadFile(file)), hash);
  CampaignDevice device;
  EXPECT_TRUE(ReadCampaignCalibration(file, &device).ok());
  EXPECT_EQ(device.width, 560);
}

TEST_F(CampaignExportTest, AChangedPictureOrAnUnusableTargetStopsItAndLeavesNothing) {
  const auto before = TreeOf(dir_);
  EXPECT_THAT(Why(ExportCampaign({dir_, dir_ / "out", false, 5}, {})), HasSubstr("lies in the campaign"));
  EXPECT_THAT(Why(ExportCampaign({dir_, dir_, false, 5}, {})), HasSubstr("not an empty folder"));
  EXPECT_THAT(Why(ExportCampaign({dir_, "/proc/out", false, 5}, {})), HasSubstr("cannot write"));
  EXPECT_EQ(TreeOf(dir_), before);
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  EXPECT_EQ(ExportCampaign({dir_, out_, false, 5}, context).error().code, ErrorCode::kCancelled);
  std::ofstream(Folder() / "stripesHand1.png", std::ios::app) << "x";
  EXPECT_THAT(Why(ExportCampaign({dir_, out_, false, 5}, {})), HasSubstr("was changed"));
  EXPECT_FALSE(fs::exists(out_));
  for (const auto& entry : fs::directory_iterator(temp_.path())) EXPECT_EQ(entry.path(), dir_);
}

std::vector<CampaignPerson> People(int young_men, int young_women, int old_men, int old_women) {
  std::vector<CampaignPerson> people;
  const auto add = [&](int count, const char* sex, const char* age) {
    for (int i = 0; i < count; ++i) {
      people.push_back({"p" + std::to_string(people.size()), sex, age, "2024-01-01", false});
    }
  };
  add(young_men, "man", "20-29");
  add(young_women, "woman", "30-39");
  add(old_men, "man", "60-69");
  add(old_women, "woman", "over-69");
  return people;
}

TEST(CampaignExportPeopleTest, SmallGroupsAreToldOfNobody) {
  const auto told = [](const std::vector<CampaignPerson>& people, int least) {
    auto exported = DrawExportIds(people);
    auto attributes = TellGroups(people, least, &exported);
    for (const auto& [id, person] : exported) {
      EXPECT_EQ(person.sex.empty(), std::count(attributes.begin(), attributes.end(), "sex") == 0);
      EXPECT_EQ(person.age_group.empty(), std::count(attributes.begin(), attributes.end(), "age_group") == 0);
    }
    return attributes;
  };
  EXPECT_THAT(told(People(5, 5, 5, 5), 5), ElementsAre("sex", "age_group"));
  EXPECT_THAT(told(People(5, 5, 0, 0), 5), ElementsAre("sex", "age_group"));
  EXPECT_THAT(told(People(5, 5, 5, 4), 5), ElementsAre("sex")) << "four old women";
  EXPECT_THAT(told(People(18, 2, 0, 0), 5), ElementsAre("age_group")) << "the document's two women";
  EXPECT_THAT(told(People(18, 2, 0, 0), 2), ElementsAre("sex", "age_group"));
  EXPECT_THAT(told(People(9, 0, 0, 1), 5), IsEmpty());
}

TEST(CampaignExportPeopleTest, NewIdsAreUniqueAndNobodysOldOne) {
  const auto people = People(500, 500, 0, 0);
  std::set<std::string> ids;
  for (const auto& [id, person] : DrawExportIds(people)) ids.insert(person.id);
  EXPECT_EQ(ids.size(), people.size());
  for (const CampaignPerson& p : people) EXPECT_EQ(ids.count(p.id), 0U);
}

}  // namespace
}  // namespace dorsum
