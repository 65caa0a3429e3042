// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_files.h"

#include <cctype>
#include <functional>

#include "base/json.h"
#include "jobs/campaign_fixture_test.h"
#include "jobs/campaign_json.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class CampaignFilesTest : public CampaignFixture {
 protected:
  CampaignFilesTest() { EXPECT_TRUE(Capture(1).ok()); }
  // Writes the manifest with this change and a seal that fits: only a hostile hand does that.
  std::string ReadManifestWith(const std::function<void(Json*)>& change) {
    const fs::path path = SessionFolder(dir_, "p01", 1) / kSessionManifest;
    Json json = *ReadSealed(path);
    const std::string before = *ReadFile(path);
    change(&json);
    EXPECT_TRUE(WriteSealed(path, json).ok());
    std::string why = Why(ReadSession(dir_, "p01", 1));
    EXPECT_TRUE(WriteFile(path, before).ok());
    return why;
  }
};

TEST_F(CampaignFilesTest, FilesThatAreTornOrHaveAByteChangedAreRefused) {
  const std::vector<std::pair<fs::path, std::function<bool()>>> files = {
      {dir_ / kCampaignJson, [&] { return ReadCampaign(dir_).ok(); }},
      {PersonFolder(dir_, "p01") / kPersonJson, [&] { return ReadPerson(dir_, "p01").ok(); }},
      {SessionFolder(dir_, "p01", 1) / kSessionManifest, [&] { return ReadSession(dir_, "p01", 1).ok(); }}};
  for (const auto& [path, reads] : files) {
    const std::string whole = *ReadFile(path);
    ASSERT_TRUE(reads()) << path;
    for (std::size_t n = 0; n + 1 < whole.size(); n += 7) {  // JSON does not miss the line's end
      std::ofstream(path, std::ios::binary) << whole.substr(0, n);
      EXPECT_FALSE(reads()) << path << " cut to " << n;
      // A changed byte is refused unless it is white space between the values.
      std::string changed = whole;
      changed[n] = static_cast<char>(changed[n] ^ 1);
      if (std::isspace(static_cast<unsigned char>(whole[n])) != 0) continue;
      std::ofstream(path, std::ios::binary) << changed;
      EXPECT_FALSE(reads()) << path << " changed at " << n;
    }
    std::ofstream(path, std::ios::binary) << whole;
    ASSERT_TRUE(reads()) << path;
  }
}

TEST_F(CampaignFilesTest, AManifestCannotNameWhatIsNoCapture) {
  EXPECT_EQ(ReadManifestWith([](Json*) {}), "");
  const auto capture = [](Json* json) -> Json& { return (*json)["captures"][0]; };
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["files"][0]["name"] = "../../p02/person.json"; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["files"][1]["name"] = "bgHand.png"; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["files"][0]["sha256"] = "../x"; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["files"][0]["bytes"] = -1; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["files"] = Json::array(); }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["hand"] = "../right"; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["capture"] = 1e300; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["capture"] = 0; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["lasers"] = {1, 0}; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j)["calibration"] = "../../x"; }), "");
  EXPECT_NE(ReadManifestWith([&](Json* j) { capture(j) = 7; }), "");
  EXPECT_NE(ReadManifestWith([](Json* j) { (*j)["captures"] = "x"; }), "");
  EXPECT_NE(ReadManifestWith([](Json* j) { (*j)["session"] = 2; }), "");
  EXPECT_NE(ReadManifestWith([](Json* j) { (*j)["version"] = 2; }), "");
  EXPECT_NE(ReadManifestWith([](Json* j) { (*j)["unfinished"] = {{"hand", ".."}, {"capture", 1}}; }), "");
  EXPECT_THAT(ReadManifestWith([&](Json* j) {
                Json again = capture(j);
                (*j)["captures"].push_back(again);
              }),
              HasSubstr("twice"));
}

TEST_F(CampaignFilesTest, APersonsFileInAnothersFolderIsRefused) {
  ASSERT_TRUE(Person("p02").ok());
  fs::copy_file(PersonFolder(dir_, "p01") / kPersonJson, PersonFolder(dir_, "p02") / kPersonJson,
                fs::copy_options::overwrite_existing);
  EXPECT_THAT(Why(ReadPerson(dir_, "p02")), HasSubstr("'id'"));
}

}  // namespace
}  // namespace dorsum
