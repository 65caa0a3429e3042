// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <algorithm>
#include <csignal>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::size_t CountEntries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// While it lives, no file grows beyond a few bytes, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    rlimit limit = old_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit old_{};
  void (*handler_)(int) = nullptr;
};

TEST(Files, BytesSurviveARoundTrip) {
  const TempFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(WriteFile(folder / "x", bytes).ok());
  EXPECT_EQ(ReadFile(folder / "x").value(), bytes);
  ASSERT_TRUE(WriteFile(folder / "x", "").ok());
  EXPECT_EQ(ReadFile(folder / "x").value(), "");
}

TEST(Files, AFullDiskLeavesTheOldContentAndNothingBeside) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFile(folder / "x", "old").ok());
  Status status;
  {
    const FullDisk full(100);
    status = WriteFile(folder / "x", std::string(100000, 'n'));
  }
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(status.error().message, HasSubstr((folder / "x").string()));
  EXPECT_EQ(ReadFile(folder / "x").value(), "old");
  EXPECT_EQ(CountEntries(folder.path()), 1U);
}

TEST(Files, AFolderInTheWayIsAnErrorAndStays) {
  const TempFolder folder;
  fs::create_directories(folder / "x/inside");
  const Status status = WriteFile(folder / "x", "new");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(fs::is_directory(folder / "x/inside"));
  EXPECT_EQ(CountEntries(folder.path()), 1U);
}

TEST(Files, WritingIntoAMissingFolderIsAnError) {
  const TempFolder folder;
  EXPECT_FALSE(WriteFile(folder / "none/x", "new").ok());
  EXPECT_FALSE(fs::exists(folder / "none"));
}

TEST(Files, UnreadableThingsAreNamed) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFile(folder / "big", "12345").ok());
  EXPECT_THAT(ReadFile(folder / "none").error().message, HasSubstr("there is no file"));
  EXPECT_THAT(ReadFile(folder.path()).error().message, HasSubstr("is not a file"));
  EXPECT_THAT(ReadFile(folder / "big", 4).error().message, HasSubstr("at most 4"));
  EXPECT_EQ(ReadFile(folder / "big", 5).value(), "12345");
  EXPECT_FALSE(ReadFile(folder / std::string(3000, 'x')).ok());
}

TEST(Files, HashesAndBase64AreTheStandardOnes) {
  EXPECT_EQ(Sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(EncodeBase64("Man"), "TWFu");
  EXPECT_EQ(EncodeBase64("M"), "TQ==");
  EXPECT_EQ(EncodeBase64(""), "");
  for (const std::string& bytes : {std::string(), std::string("\0\xff", 2), std::string(1000, '\x7f')}) {
    EXPECT_EQ(DecodeBase64(EncodeBase64(bytes)).value(), bytes);
  }
  EXPECT_FALSE(DecodeBase64("TW!u").ok());
  EXPECT_FALSE(DecodeBase64("TWFuT").ok());
}

TEST(StagedFolder, AppearsOnlyWithCommit) {
  const TempFolder folder;
  const fs::path target = folder / "made/out";
  {
    auto staged = StagedFolder::Create(target);
    ASSERT_TRUE(staged.ok());
    ASSERT_TRUE(WriteFile(staged->path() / "a", "1").ok());
    EXPECT_FALSE(fs::exists(target));
    ASSERT_TRUE(staged->Commit().ok());
  }
  EXPECT_EQ(ReadFile(target / "a").value(), "1");
  EXPECT_EQ(CountEntries(folder / "made"), 1U);
}

TEST(StagedFolder, WithoutCommitNothingStaysBehind) {
  const TempFolder folder;
  {
    const auto staged = StagedFolder::Create(folder / "out");
    ASSERT_TRUE(staged.ok());
    ASSERT_TRUE(WriteFile(staged->path() / "a", "1").ok());
  }
  EXPECT_EQ(CountEntries(folder.path()), 0U);
}

TEST(StagedFolder, WithoutCommitTheFoldersMadeAboveItGoTooButNobodyElses) {
  const TempFolder folder;
  fs::create_directories(folder / "theirs");
  { ASSERT_TRUE(StagedFolder::Create(folder / "theirs/made/deep/out").ok()); }
  EXPECT_TRUE(fs::is_empty(folder / "theirs"));
  {
    const auto staged = StagedFolder::Create(folder / "theirs/made/deep/out");
    ASSERT_TRUE(staged.ok());
    ASSERT_TRUE(WriteFile(folder / "theirs/made/used", "by another program").ok());
  }
  EXPECT_EQ(ReadFile(folder / "theirs/made/used").value(), "by another program");
  EXPECT_FALSE(fs::exists(folder / "theirs/made/deep"));
}

TEST(StagedFolder, ForeignFilesOfTheTargetStay) {
  const TempFolder folder;
  const fs::path target = folder / "out";
  fs::create_directories(target / "sub");
  ASSERT_TRUE(WriteFile(target / "sub/theirs", "theirs").ok());
  ASSERT_TRUE(WriteFile(target / "a", "old").ok());
  {
    auto staged = StagedFolder::Create(target.string() + "/");
    ASSERT_TRUE(staged.ok());
    fs::create_directories(staged->path() / "sub");
    ASSERT_TRUE(WriteFile(staged->path() / "a", "new").ok());
    ASSERT_TRUE(WriteFile(staged->path() / "sub/b", "new").ok());
    EXPECT_EQ(ReadFile(target / "a").value(), "old");
    ASSERT_TRUE(staged->Commit().ok());
  }
  EXPECT_EQ(ReadFile(target / "a").value(), "new");
  EXPECT_EQ(ReadFile(target / "sub/b").value(), "new");
  EXPECT_EQ(ReadFile(target / "sub/theirs").value(), "theirs");
  EXPECT_EQ(CountEntries(folder.path()), 1U);
}

TEST(StagedFolder, AFileInPlaceOfTheTargetIsAnError) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFile(folder / "out", "file").ok());
  const auto staged = StagedFolder::Create(folder / "out");
  ASSERT_FALSE(staged.ok());
  EXPECT_THAT(staged.error().message, HasSubstr("it is a file"));
  EXPECT_FALSE(StagedFolder::Create(folder / "out/below").ok());
  EXPECT_EQ(ReadFile(folder / "out").value(), "file");
}

TEST(StagedFolder, ANameThatTheSystemRefusesIsAnErrorNotAnException) {
  const TempFolder folder;
  const auto staged = StagedFolder::Create(folder / std::string(300, 'x'));
  ASSERT_FALSE(staged.ok());
  EXPECT_EQ(staged.error().code, ErrorCode::kBadInput);
}

TEST(StagedFolder, AReadOnlyParentIsAnError) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const TempFolder folder;
  fs::create_directories(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  const auto staged = StagedFolder::Create(folder / "locked/out");
  fs::permissions(folder / "locked", fs::perms::owner_all);
  ASSERT_FALSE(staged.ok());
  EXPECT_THAT(staged.error().message, HasSubstr("cannot write"));
}

TEST(StagedFolder, MovingKeepsOneOwner) {
  const TempFolder folder;
  {
    auto first = StagedFolder::Create(folder / "out");
    ASSERT_TRUE(first.ok());
    const fs::path staging = first->path();
    const StagedFolder second = std::move(*first);
    EXPECT_EQ(second.path(), staging);
    EXPECT_TRUE(fs::exists(staging));
  }
  EXPECT_EQ(CountEntries(folder.path()), 0U);
}

}  // namespace
}  // namespace dorsum
