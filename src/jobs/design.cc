// SPDX-License-Identifier: Apache-2.0
#include "jobs/design.h"

#include <cstdio>

#include "captures/device_description.h"
#include "jobs/design_outputs.h"

namespace dorsum {
namespace {

Status Check(const DesignRequest& request) {
  if (request.hand_mm.size() != 2 || !(request.hand_mm[0] >= 10.0 && request.hand_mm[0] <= 1000.0) ||
      !(request.hand_mm[1] >= 10.0 && request.hand_mm[1] <= 1000.0)) {
    return UsageError("--hand-mm takes two lengths from 10 to 1000 mm: across and along the stripes");
  }
  if (!(request.surface.albedo >= 0.01 && request.surface.albedo <= 1.0))
    return UsageError("--albedo takes a share from 0.01 to 1");
  if (request.surface.pooled_rows < 1 || request.surface.pooled_rows > 1000)
    return UsageError("--pooled-rows takes 1 to 1000 image rows");
  return {};
}

// A device must be calibrated, too. Says so where the board had to shrink.
std::string FitBoard(DesignedDevice* device) {
  double& square = device->description.board.square_mm;
  const double fits = FittingSquare(*device);
  if (fits >= square) return {};
  char text[200];
  std::snprintf(
      text, sizeof text,
      "the chessboard's squares of %g mm are too large for this camera's view; the description has %g mm",
      square, fits);
  square = fits;
  return text;
}

}  // namespace

Result<DesignSummary> Design(const DesignRequest& request, const Context& context) {
  DORSUM_RETURN_IF_ERROR(Check(request));
  DeviceDescription description = DefaultDevice();
  if (!request.device_path.empty()) {
    DORSUM_ASSIGN_OR_RETURN(description, ReadDeviceDescription(request.device_path));
  }
  DORSUM_ASSIGN_OR_RETURN(description, ApplyChanges(std::move(description), request.changes));
  const Eigen::Vector2d hand(request.hand_mm[0], request.hand_mm[1]);
  DesignSummary summary;
  if (request.search) {
    DORSUM_ASSIGN_OR_RETURN(summary.search,
                            SearchDesigns(description, hand, request.surface, *request.search, context));
    description = summary.search->hits.front().description;
  }
  DORSUM_ASSIGN_OR_RETURN(DesignedDevice device, LayOutDevice(description, hand));
  const std::string board = FitBoard(&device);
  context.Report("judging the design", 0.9);
  summary.report = JudgeDesign(device, request.surface);
  if (!board.empty()) summary.report.warnings.push_back(board);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  if (!request.out_dir.empty()) {
    DORSUM_ASSIGN_OR_RETURN(summary.files, WriteDesign(summary, request.out_dir));
  }
  return summary;
}

}  // namespace dorsum
