// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_disk.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

Error CannotWrite(const fs::path& path, int error) {
  return BadInput("cannot write " + path.string() + ": " + std::strerror(error) +
                  "; make room or choose a folder that you may write to");
}

bool WriteAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Result<std::vector<std::string>> NamesIn(const fs::path& folder) {
  std::error_code ec;
  std::vector<std::string> names;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    names.push_back(it->path().filename().string());
  }
  if (ec) return BadInput("cannot read the folder " + folder.string() + ": " + ec.message());
  std::sort(names.begin(), names.end());
  return names;
}

Status SyncToDisk(const fs::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  // Some network file systems cannot sync a folder; what they promise is theirs.
  const bool fine = file >= 0 && (fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP);
  const int error = errno;
  if (file >= 0) close(file);
  return fine ? Status() : Status(CannotWrite(path, error));
}

fs::path AsideOf(const fs::path& path) {
  return path.parent_path() / ("." + path.filename().string() + ".part");
}

Status WriteDurably(const fs::path& path, std::string_view content) {
  const fs::path aside = AsideOf(path);
  const int file = open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return CannotWrite(path, errno);
  bool fine = WriteAll(file, content) && fsync(file) == 0;
  int error = errno;
  if (close(file) != 0 && fine) {
    fine = false;
    error = errno;
  }
  if (fine && rename(aside.c_str(), path.c_str()) != 0) {
    fine = false;
    error = errno;
  }
  if (!fine) {
    unlink(aside.c_str());
    return CannotWrite(path, error);
  }
  return SyncToDisk(path.parent_path());
}

Status MakeCampaignFolder(const fs::path& folder) {
  std::error_code ec;
  if (fs::is_directory(folder, ec)) return {};
  if (folder.has_relative_path()) DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(folder.parent_path()));
  fs::create_directory(folder, ec);
  if (ec) return CannotWrite(folder, ec.value());
  return SyncToDisk(folder.parent_path());
}

Result<CampaignLock> CampaignLock::Take(const fs::path& campaign, Kind kind, const Context& context) {
  std::error_code ec;
  if (!fs::exists(campaign / kCampaignJson, ec) && !fs::is_directory(campaign / kPeopleFolder, ec)) {
    return BadInput("there is no campaign in " + campaign.string() + "; dorsum campaign new makes one");
  }
  const fs::path path = campaign / kCampaignLock;
  int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0 && kind == Kind::kReader) {
    file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return CampaignLock(-1);  // nobody can write here
  }
  if (file < 0) return CannotWrite(path, errno);
  CampaignLock lock(file);
  while (flock(file, (kind == Kind::kWriter ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return CannotWrite(path, errno);
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    context.Report("waiting for another campaign command", 0.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return lock;
}

CampaignLock::~CampaignLock() {
  if (file_ >= 0) close(file_);
}

Result<WorkFolder> WorkFolder::Create(const fs::path& parent) {
  std::string path = (parent / (std::string(kWorkPrefix) + "XXXXXX")).string();
  if (mkdtemp(path.data()) == nullptr) return CannotWrite(parent, errno);
  const int file = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  WorkFolder folder(path, file);
  if (file < 0 || flock(file, LOCK_EX | LOCK_NB) != 0) return CannotWrite(path, errno);
  return folder;
}

bool WorkFolder::IsDead(const fs::path& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return false;
  const bool dead = flock(file, LOCK_EX | LOCK_NB) == 0;
  close(file);
  return dead;
}

WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {
  other.path_.clear();
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (file_ >= 0) close(file_);
}

}  // namespace dorsum
