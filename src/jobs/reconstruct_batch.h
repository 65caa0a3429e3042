// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "jobs/reconstruct.h"

namespace dorsum {

enum class BatchOutcome {
  kDone,
  kKept,    // an earlier run with the same recipe had done it
  kFailed,  // `error` says why; what an earlier run wrote stays
};

const char* OutcomeText(BatchOutcome outcome);  // "done", "kept" or "failed"

struct BatchCapture {
  std::string name;  // of its folder
  BatchOutcome outcome = BatchOutcome::kDone;
  std::size_t points = 0, faces = 0;
  std::string error;
  std::vector<std::string> warnings;
};

struct BatchSummary {
  std::vector<BatchCapture> captures;  // by name
  int Count(BatchOutcome outcome) const;
};

inline constexpr const char* kBatchTable = "summary.csv";

// Whether a folder is a campaign (docs/campaign.md), which knows the calibrations of its captures.
bool HoldsCampaign(const std::filesystem::path& dir);

// The job behind `dorsum reconstruct --batch`: every folder below request.capture_dir that holds a bgHand
// becomes a folder of the same name below request.out_dir, and OUT/summary.csv lists them all. Of a campaign,
// every capture that counts becomes a folder ID_sSESSION_HAND_kNUMBER, with the calibration that it was
// stored with unless request.calibration_path names one. Captures that an earlier run reconstructed from the
// same images with the same calibration, options and program are kept, so that a run that was interrupted
// goes on where it stopped. A capture that fails does not stop the others. One thread reads ahead,
// context.threads work on captures side by side, each alone.
Result<BatchSummary> ReconstructBatch(const ReconstructRequest& request, const Context& context);

}  // namespace dorsum
