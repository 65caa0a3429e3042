// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <csignal>
#include <thread>

#include <sys/resource.h>

#include "jobs/campaign_add.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_fixture_test.h"
#include "jobs/campaign_remove.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CampaignAddFaultsTest : public CampaignFixture {};

TEST_F(CampaignAddFaultsTest, ADeviceThatFailsOrIsInterruptedLeavesNothing) {
  const CaptureMaker failing = [](const fs::path& folder, const Context&) {
    WriteNoiseCapture(folder, 1, 1);
    return Status(Error{ErrorCode::kDevice, "the camera is gone"});
  };
  ExpectRefused([&] { return AddCapture(Wanted(), failing, {}); }, "the camera is gone");
  EXPECT_EQ(AddCapture(Wanted(), failing, {}).error().code, ErrorCode::kDevice);
  std::atomic<bool> cancel{false};
  Context context;
  context.cancel = &cancel;
  const CaptureMaker interrupted = [&](const fs::path& folder, const Context&) {
    WriteNoiseCapture(folder, 1);
    cancel = true;
    return Status();
  };
  ExpectRefused([&] { return AddCapture(Wanted(), interrupted, context); }, "interrupted");
}

TEST_F(CampaignAddFaultsTest, TwoWhoAddAtOnceDoNotMeet) {
  ASSERT_TRUE(Person("p02").ok());
  std::atomic<int> done{0};
  const auto work = [&](const std::string& id, int seed) {
    for (const CampaignHand hand : {CampaignHand::kLeft, CampaignHand::kRight}) {
      for (int k = 0; k < 2; ++k) {
        const auto added = Capture(++seed, id, hand);
        EXPECT_TRUE(added.ok()) << Why(added);
        ++done;
      }
    }
  };
  { const std::jthread one(work, "p01", 100), two(work, "p02", 200); }
  EXPECT_EQ(done, 8);
  EXPECT_EQ(Counted(), 8U);
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignAddFaultsTest, TheLastFreePlaceIsGivenOnce) {
  ASSERT_TRUE(Capture(1).ok());
  // While the one captures, another takes the place.
  const auto slow = AddCapture(Wanted(),
                               [&](const fs::path& folder, const Context& context) {
                                 EXPECT_TRUE(Capture(2).ok());
                                 return Noise(3)(folder, context);
                               },
                               {});
  EXPECT_THAT(Why(slow), HasSubstr("has all 2 captures"));
  EXPECT_EQ(Counted(), 2U);
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignAddFaultsTest, APersonRemovedDuringACaptureStaysRemoved) {
  const auto added = AddCapture(Wanted(),
                                [&](const fs::path& folder, const Context& context) {
                                  EXPECT_TRUE(RemoveFromCampaign({dir_, "p01", 0, {}}, {}).ok());
                                  return Noise(3)(folder, context);  // makes the folders above it again
                                },
                                {});
  EXPECT_THAT(Why(added), HasSubstr("was removed meanwhile"));
  EXPECT_FALSE(OccursIn(dir_, "p01"));
  EXPECT_THAT(Findings(), IsEmpty());
}

TEST_F(CampaignAddFaultsTest, AWaitForAnotherCommandCanBeEnded) {
  const auto other = CampaignLock::Take(dir_, CampaignLock::Kind::kReader, {});
  ASSERT_TRUE(other.ok());
  std::atomic<bool> cancel{false};
  bool waited = false;
  Context context;
  context.cancel = &cancel;
  context.progress = [&](std::string_view stage, double) {
    waited = stage.find("waiting") != std::string_view::npos;
    cancel = true;
  };
  const auto added = AddCapture(Wanted(), Noise(1), context);
  ASSERT_FALSE(added.ok());
  EXPECT_EQ(added.error().code, ErrorCode::kCancelled);
  EXPECT_TRUE(waited);
}

// No file of this process may become larger, as on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(std::size_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    Set(bytes);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  void Set(std::size_t bytes) const {
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }

 private:
  rlimit before_{};
};

TEST_F(CampaignAddFaultsTest, ADiskThatIsFullAtAnyStepLeavesTheCampaignAsItWas) {
  ASSERT_TRUE(Capture(1).ok());
  WriteNoiseCapture(temp_ / "source", 2);
  ExpectRefused(
      [&] {
        const FullDisk full(1000);  // the first picture does not fit
        return AddCapture(Wanted(), ImportCapture(temp_ / "source"), {});
      },
      "cannot write");
  const std::size_t manifest = fs::file_size(SessionFolder(dir_, "p01", 1) / kSessionManifest);
  for (const std::size_t room : {std::size_t{0}, manifest + 200}) {  // the intent, or what then counts
    FullDisk disk(std::size_t{1} << 30);
    ExpectRefused(
        [&] {
          auto added = AddCapture(Wanted(),
                                  [&](const fs::path& folder, const Context& context) {
                                    Status made = Noise(3)(folder, context);
                                    disk.Set(room);
                                    return made;
                                  },
                                  {});
          disk.Set(std::size_t{1} << 30);
          return added;
        },
        "manifest.json");
  }
  EXPECT_THAT(Findings(), IsEmpty());
  EXPECT_TRUE(Capture(3).ok());
}

TEST_F(CampaignAddFaultsTest, ADiskThatTakesNothingIsSaid) {
  // A file where a folder is needed stands for it; permissions do not hold root.
  fs::remove_all(dir_ / kPeopleFolder);
  std::ofstream(dir_ / kPeopleFolder) << "";
  EXPECT_THAT(Why(Person("p02")), HasSubstr((dir_ / kPeopleFolder).string()));
  EXPECT_THAT(Why(Capture(1)), HasSubstr("p01"));
}

}  // namespace
}  // namespace dorsum
