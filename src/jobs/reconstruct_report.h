// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "captures/capture.h"
#include "jobs/reconstruct.h"
#include "report/reconstruction_report.h"

namespace dorsum {

// What report.html and overview.png tell of one reconstruction.
ReconstructionReportData CollectReportData(const ReconstructRequest& request, const Reconstruction& result,
                                           const CaptureImages& capture, const ReadyCalibration& ready);

}  // namespace dorsum
