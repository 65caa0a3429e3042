// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/context.h"
#include "base/result.h"

namespace dorsum {

// What a campaign needs of the file system beyond base/files.h: bytes that are on the disk when a command
// says so, one writer at a time, and folders of commands that no longer run told from those that do.

// Names in a folder in order, hidden ones too; an error when it cannot be read.
Result<std::vector<std::string>> NamesIn(const std::filesystem::path& folder);

// Asks the disk to hold what was written to a file or folder.
Status SyncToDisk(const std::filesystem::path& path);

// Writes aside (AsideOf), syncs, renames, syncs the folder: the old content or all of the new, also after a
// power cut. One writer at a time.
Status WriteDurably(const std::filesystem::path& path, std::string_view content);
std::filesystem::path AsideOf(const std::filesystem::path& path);  // DIR/.NAME.part

// Makes a folder with its parents, each synced.
Status MakeCampaignFolder(const std::filesystem::path& folder);

// The lock of a campaign (flock on campaign.lock): any number of readers, or one writer. A process that dies
// leaves none.
class CampaignLock {
 public:
  enum class Kind { kReader, kWriter };
  // Waits for others, and says so as progress; context.cancel ends the wait. An error where there is no
  // campaign. Readers of a campaign on a read-only disk without a lock file go without.
  static Result<CampaignLock> Take(const std::filesystem::path& campaign, Kind kind, const Context& context);
  CampaignLock(CampaignLock&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  CampaignLock& operator=(CampaignLock&&) = delete;
  ~CampaignLock();

 private:
  explicit CampaignLock(int file) : file_(file) {}
  int file_ = -1;
};

// A hidden folder that one command fills and that goes with it. It is locked as long as the command lives, so
// that WorkFolder::IsDead tells what a killed one left.
class WorkFolder {
 public:
  // To be called by the campaign's writer, since a folder that is not locked yet looks dead.
  static Result<WorkFolder> Create(const std::filesystem::path& parent);
  static bool IsDead(const std::filesystem::path& folder);
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  WorkFolder(std::filesystem::path path, int file) : path_(std::move(path)), file_(file) {}
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace dorsum
