// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "jobs/campaign.h"

namespace dorsum {

struct AddPersonRequest {
  std::filesystem::path dir;
  CampaignPerson person;  // a real one needs a consent date, a virtual one must not have one
  bool correct = false;   // the person is there already, and what was said of them is replaced
  std::string today;  // YYYY-MM-DD, the last day on which consent can have been given; empty: by the clock
};

// The job behind `dorsum campaign add` for a person. An id that is there already, in whatever case of
// letters, is refused; so are real people among virtual ones and the other way round.
Status AddPerson(const AddPersonRequest& request, const Context& context);

// Makes one capture folder (DESIGN §4): `folder` does not exist yet, the folder above it does.
using CaptureMaker = std::function<Status(const std::filesystem::path& folder, const Context& context)>;

struct AddCaptureRequest {
  std::filesystem::path dir;
  std::string id;
  CampaignHand hand = CampaignHand::kLeft;
  std::optional<int> session;         // none: the person's last one, or the first
  std::filesystem::path calibration;  // the device's from now on; empty: the campaign's present one
  std::string source;                 // what messages call the pictures: a folder, a device
};

struct AddedCapture {
  CampaignCapture capture;
  int planned = 0;                    // captures of that hand in that session
  std::vector<std::string> warnings;  // one sentence each
};

// The job behind `dorsum campaign add` for a capture. The campaign is open to others while the maker works;
// the capture gets its number, and counts, only when all of it is on the disk. Refuses pictures that the
// campaign has already, that are of another device, or that LoadCapture refuses.
Result<AddedCapture> AddCapture(const AddCaptureRequest& request, const CaptureMaker& maker,
                                const Context& context);

// Makes a capture by copying the pictures of a capture folder; what else lies there stays there.
CaptureMaker ImportCapture(const std::filesystem::path& capture_dir);

// The calibration that new captures belong to; none when the campaign has none yet.
Result<std::optional<std::filesystem::path>> PresentCalibration(const std::filesystem::path& dir);

}  // namespace dorsum
