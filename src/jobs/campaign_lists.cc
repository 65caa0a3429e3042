// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <utility>

#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"

namespace dorsum {

namespace fs = std::filesystem;

Result<std::vector<std::string>> ListPeople(const fs::path& dir) {
  DORSUM_ASSIGN_OR_RETURN(std::vector<std::string> names, NamesIn(dir / kPeopleFolder));
  std::error_code ec;
  std::erase_if(names, [&](const std::string& name) {
    return !CheckPersonId(name).ok() || !fs::is_directory(PersonFolder(dir, name), ec);
  });
  return names;
}

Result<std::vector<int>> ListSessions(const fs::path& dir, const std::string& id) {
  std::error_code ec;
  const fs::path folder = PersonFolder(dir, id) / kSessionsFolder;
  if (!fs::exists(folder, ec)) return std::vector<int>{};
  DORSUM_ASSIGN_OR_RETURN(const std::vector<std::string> names, NamesIn(folder));
  const std::set<std::string> there(names.begin(), names.end());
  std::vector<int> sessions;
  for (int n = 1; n <= kMaxSessions; ++n) {
    if (there.contains(std::to_string(n))) sessions.push_back(n);
  }
  return sessions;
}

Result<std::vector<CampaignCapture>> ListCaptures(const fs::path& dir, std::vector<std::string>* problems) {
  std::vector<CampaignCapture> out;
  // Whether to go on after this error.
  const auto noted = [&](const Error& error) {
    if (problems != nullptr) problems->push_back(error.message);
    return problems != nullptr;
  };
  DORSUM_ASSIGN_OR_RETURN(const std::vector<std::string> people, ListPeople(dir));
  for (const std::string& id : people) {
    const auto sessions = ListSessions(dir, id);
    if (!sessions.ok()) {
      if (!noted(sessions.error())) return sessions.error();
      continue;
    }
    for (const int n : *sessions) {
      const auto session = ReadSession(dir, id, n);
      if (!session.ok()) {
        if (!noted(session.error())) return session.error();
        continue;
      }
      std::vector<StoredCapture> captures = session->captures;
      std::sort(captures.begin(), captures.end(), [](const StoredCapture& a, const StoredCapture& b) {
        return std::pair(a.hand, a.number) < std::pair(b.hand, b.number);
      });
      for (StoredCapture& c : captures) out.push_back({id, n, std::move(c)});
    }
  }
  return out;
}

}  // namespace dorsum
