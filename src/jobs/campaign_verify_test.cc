// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_verify.h"

#include <atomic>

#include "jobs/campaign_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class CampaignVerifyTest : public CampaignFixture {
 protected:
  CampaignVerifyTest() {
    EXPECT_TRUE(Capture(1).ok());
    EXPECT_TRUE(Capture(2).ok());
  }
  void ExpectOneFinding(const std::string& where, const std::string& what) {
    EXPECT_THAT(Findings(), ElementsAre(AllOf(HasSubstr(where), HasSubstr(what))));
  }
};

TEST_F(CampaignVerifyTest, AWholeCampaignHasNoFindings) {
  for (const fs::path& spelt : {dir_, dir_ / "", dir_ / "." / "people" / ".."}) {
    const auto v = VerifyCampaign(spelt, {});
    ASSERT_TRUE(v.ok());
    EXPECT_THAT(v->findings, IsEmpty());
    EXPECT_EQ(v->people, 1);
    EXPECT_EQ(v->captures, 2);
    EXPECT_EQ(v->files, 6);
    EXPECT_GT(v->bytes, 6U * 32 * 24);
  }
}

TEST_F(CampaignVerifyTest, OneChangedByteIsFound) {
  const fs::path path = Folder(2) / "stripesHand1.png";
  std::string bytes = *ReadFile(path);
  for (const std::size_t at : {std::size_t{0}, bytes.size() / 2, bytes.size() - 1}) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    std::ofstream(path, std::ios::binary) << changed;
    ExpectOneFinding(path.string(), "was changed");
  }
  std::ofstream(path, std::ios::binary) << bytes << "x";
  ExpectOneFinding(path.string(), std::to_string(bytes.size()) + " were stored");
  std::ofstream(path, std::ios::binary) << "";
  ExpectOneFinding(path.string(), "has 0 bytes");
}

TEST_F(CampaignVerifyTest, MissingFilesAndFoldersAreFound) {
  fs::remove(Folder(1) / "bgHand.png");
  ExpectOneFinding("left/1/bgHand.png", "is missing");
  fs::remove_all(Folder(1));
  EXPECT_THAT(Findings(), SizeIs(3));
  fs::remove(PersonFolder(dir_, "p01") / kPersonJson);
  EXPECT_THAT(Findings(), SizeIs(4));
  fs::remove(dir_ / kCampaignJson);
  EXPECT_THAT(Findings(), SizeIs(5));
  EXPECT_FALSE(VerifyCampaign(temp_ / "none", {}).ok());
}

TEST_F(CampaignVerifyTest, WhatDoesNotBelongThereIsFound) {
  const std::vector<fs::path> files = {dir_ / "notes.txt",
                                       dir_ / kPeopleFolder / "list.csv",
                                       PersonFolder(dir_, "p01") / "face.jpg",
                                       Folder(1) / "extra.png",
                                       Folder(1) / "stripesHand5.png",
                                       SessionFolder(dir_, "p01", 1) / ".hidden",
                                       dir_ / ".manifest.json.part"};
  for (const fs::path& file : files) {
    std::ofstream(file) << "x";
    ExpectOneFinding(file.string(), "does not belong");
    fs::remove(file);
  }
  const std::vector<fs::path> folders = {Folder(3), SessionFolder(dir_, "p01", 1) / "middle",
                                         dir_ / kPeopleFolder / "no id", PersonFolder(dir_, "p01") / "x"};
  for (const fs::path& folder : folders) {
    fs::create_directories(folder);
    ExpectOneFinding(folder.string(), "does not belong");
    fs::remove(folder);
  }
  fs::create_symlink("/etc", Folder(1) / "more");
  ExpectOneFinding("more", "is a link");
}

TEST_F(CampaignVerifyTest, ABrokenManifestIsAFindingAndTheRestIsStillChecked) {
  ASSERT_TRUE(Person("p02").ok());
  ASSERT_TRUE(Capture(3, "p02").ok());
  const fs::path manifest = SessionFolder(dir_, "p01", 1) / kSessionManifest;
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[1, 2]"), std::string("null"), std::string(100000, '['),
        std::string("\xff\xfe\0x", 4), std::string(R"({"sha256": 7})")}) {
    std::ofstream(manifest, std::ios::binary) << text;
    const auto v = VerifyCampaign(dir_, {});
    ASSERT_TRUE(v.ok());
    EXPECT_THAT(v->findings, ElementsAre(HasSubstr(manifest.string())));
    EXPECT_EQ(v->captures, 1) << "the other person's";
  }
  fs::remove(manifest);
  ExpectOneFinding(manifest.string(), "no file");
}

TEST_F(CampaignVerifyTest, AChangedCampaignOrPersonFileIsFound) {
  for (const fs::path& path : {dir_ / kCampaignJson, PersonFolder(dir_, "p01") / kPersonJson}) {
    const std::string text = *ReadFile(path);
    std::string changed = text;
    const std::size_t digit = text.find('2');
    changed[digit] = '3';
    std::ofstream(path, std::ios::binary) << changed;
    ExpectOneFinding(path.string(), "its checksum is wrong");
    std::ofstream(path, std::ios::binary) << text;
  }
}

TEST_F(CampaignVerifyTest, ACalibrationThatIsMissingOrChangedIsFound) {
  CampaignSession session = *ReadSession(dir_, "p01", 1);
  const fs::path file = CalibrationFile(dir_, Sha256Hex("text"));
  session.captures[0].calibration = Sha256Hex("text");
  ASSERT_TRUE(WriteSession(dir_, "p01", session).ok());
  ExpectOneFinding(file.string(), "is missing");
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "text";
  EXPECT_THAT(Findings(), IsEmpty());
  std::ofstream(file) << "texT";
  ExpectOneFinding(file.string(), "was changed");
}

TEST_F(CampaignVerifyTest, ItCanBeInterrupted) {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const auto v = VerifyCampaign(dir_, context);
  ASSERT_FALSE(v.ok());
  EXPECT_EQ(v.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
