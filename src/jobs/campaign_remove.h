// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/context.h"
#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

struct RemoveRequest {
  std::filesystem::path dir;
  std::string id;
  int session = 0;                    // with a key: only this capture
  std::optional<CaptureKey> capture;  // none: the person
};

struct RemoveSummary {
  int captures = 0;       // deleted with the person, or the one
  bool finished = false;  // the person was gone already: a deletion that was interrupted is finished now
};

// The job behind `dorsum campaign remove`: deletes one person with all that the campaign holds of them and
// every mention of their id, or one capture, to be taken again. A person counts no more from the first moment
// on, and a deletion that is killed is finished by the next command that writes. The files are deleted, not
// overwritten: what a file system, an SSD or a backup keeps is beyond this program (docs/campaign.md).
Result<RemoveSummary> RemoveFromCampaign(const RemoveRequest& request, const Context& context);

}  // namespace dorsum
