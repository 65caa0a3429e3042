// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_recovery.h"

#include <csignal>

#include <sys/wait.h>
#include <unistd.h>

#include "jobs/campaign_fixture_test.h"
#include "jobs/campaign_remove.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A campaign with one capture, and what kills leave beside it.
class CampaignRecoveryTest : public CampaignFixture {
 protected:
  CampaignRecoveryTest() { EXPECT_TRUE(Capture(1).ok()); }
  Recovered Recover() {
    const auto lock = CampaignLock::Take(dir_, CampaignLock::Kind::kWriter, {});
    const auto recovered = RecoverCampaign(dir_, *lock);
    EXPECT_TRUE(recovered.ok()) << Why(recovered);
    return recovered.ok() ? *recovered : Recovered{};
  }
  void Unfinished(int number) {
    CampaignSession session = *ReadSession(dir_, "p01", 1);
    session.unfinished = CaptureKey{CampaignHand::kLeft, number};
    EXPECT_TRUE(WriteSession(dir_, "p01", session).ok());
  }
  // What was left is told, is not counted, and goes; then the next capture gets its number.
  void ExpectCleared(const std::string& finding) {
    EXPECT_EQ(Counted(), 1U);
    EXPECT_THAT(Findings(), ElementsAre(HasSubstr(finding)));
    const auto next = Capture(2);
    ASSERT_TRUE(next.ok()) << Why(next);
    EXPECT_EQ(next->capture.stored.number, 2);
    EXPECT_EQ(Counted(), 2U);
    EXPECT_THAT(Findings(), IsEmpty());
  }
};

TEST_F(CampaignRecoveryTest, KilledWhileThePicturesCome) {
  WriteNoiseCapture(PersonFolder(dir_, "p01") / ".working-abc123" / "pictures", 9, 1);
  ExpectCleared(".working-abc123 was left by a command that was killed");
}

TEST_F(CampaignRecoveryTest, KilledForRealWhileThePicturesCome) {
  const pid_t child = fork();
  if (child == 0) {
    static_cast<void>(AddCapture(Wanted(),
                                 [](const fs::path& folder, const Context&) {
                                   WriteNoiseCapture(folder, 9, 1);
                                   raise(SIGKILL);
                                   return Status();
                                 },
                                 {})
                          .ok());
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  ExpectCleared("was left by a command that was killed");
}

TEST_F(CampaignRecoveryTest, KilledAfterTheIntentWasWritten) {
  Unfinished(2);
  ExpectCleared("left/2 was being added");
}

TEST_F(CampaignRecoveryTest, KilledAfterThePicturesCameAndBeforeTheyCounted) {
  Unfinished(2);
  WriteNoiseCapture(Folder(2), 9);
  ExpectCleared("left/2 was being added");
}

TEST_F(CampaignRecoveryTest, KilledWhileTheManifestWasWritten) {
  std::ofstream(SessionFolder(dir_, "p01", 1) / ".manifest.json.part") << "{";
  ExpectCleared(".manifest.json.part does not belong");
}

TEST_F(CampaignRecoveryTest, KilledBeforeANewSessionOrPersonHadItsFile) {
  fs::create_directories(SessionFolder(dir_, "p01", 2));
  fs::create_directories(PersonFolder(dir_, "p07"));
  std::ofstream(PersonFolder(dir_, "p07") / ".person.json.part") << "{";
  EXPECT_EQ(Findings().size(), 3U);
  EXPECT_TRUE(Person("p07").ok());
  EXPECT_EQ(Capture(2)->capture.session, 1);
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignRecoveryTest, KilledInTheMiddleOfARemoval) {
  const fs::path aside = dir_ / ".removing-abc123";
  fs::create_directories(aside);
  fs::rename(PersonFolder(dir_, "p01"), aside / "person");
  fs::remove_all(aside / "person" / kSessionsFolder / "1" / "left");
  EXPECT_EQ(Counted(), 0U);
  EXPECT_THAT(Findings(), ElementsAre(HasSubstr("whose removal was interrupted")));
  const auto again = RemoveFromCampaign({dir_, "p01", 0, {}}, {});
  ASSERT_TRUE(again.ok()) << Why(again);
  EXPECT_TRUE(again->finished);
  EXPECT_FALSE(OccursIn(dir_, "p01"));
  EXPECT_THAT(Findings(), IsEmpty());
  EXPECT_FALSE(RemoveFromCampaign({dir_, "p01", 0, {}}, {}).ok());
}

TEST_F(CampaignRecoveryTest, KilledInTheMiddleOfRemovingACapture) {
  ASSERT_TRUE(Capture(2).ok());
  CampaignSession session = *ReadSession(dir_, "p01", 1);
  session.captures.pop_back();
  ASSERT_TRUE(WriteSession(dir_, "p01", session).ok());
  Unfinished(2);
  fs::remove(Folder(2) / "bgHand.png");
  EXPECT_EQ(Recover().captures, 1);
  EXPECT_FALSE(fs::exists(Folder(2)));
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignRecoveryTest, WhatACommandStillFillsStays) {
  const auto added = AddCapture(Wanted(),
                                [&](const fs::path& folder, const Context& context) {
                                  EXPECT_EQ(Recover().captures, 0);
                                  EXPECT_THAT(Findings(), IsEmpty())
                                      << "someone is adding, which is no finding";
                                  EXPECT_TRUE(fs::exists(folder.parent_path()));
                                  return Noise(2)(folder, context);
                                },
                                {});
  EXPECT_TRUE(added.ok()) << Why(added);
}

TEST_F(CampaignRecoveryTest, NothingThatCountsOrThatOthersPutThereIsTouched) {
  WriteNoiseCapture(Folder(2), 9);  // by hand: no intent speaks of it
  std::ofstream(dir_ / "notes.txt") << "mine";
  Unfinished(1);  // of a capture that counts: its folder must stay
  const auto before = TreeOf(Folder(1));
  Recover();
  EXPECT_EQ(TreeOf(Folder(1)), before);
  EXPECT_TRUE(fs::exists(Folder(2)) && fs::exists(dir_ / "notes.txt"));
  EXPECT_THAT(Why(Capture(2)), HasSubstr("no manifest names it"));
  // A manifest that cannot be read: nobody knows what counts.
  std::ofstream(SessionFolder(dir_, "p01", 1) / kSessionManifest) << "{";
  const auto all = TreeOf(dir_);
  Recover();
  EXPECT_EQ(TreeOf(dir_), all);
  EXPECT_THAT(Why(Capture(2)), HasSubstr("manifest.json"));
}

}  // namespace
}  // namespace dorsum
