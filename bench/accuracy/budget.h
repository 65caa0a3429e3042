// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/score.h"
#include "base/context.h"
#include "geometry/calibration.h"
#include "jobs/reconstruct_options.h"
#include "surface/surface_point.h"

namespace dorsum::accuracy {

// Where a reconstruction's errors come from: each stage's own error, with the truth put in the place of all
// other stages. rms of height in mm over all points on the object, so that the squares of the parts add up to
// about the square of the whole:
//   total   as scored
//   plane   the true stripe and its true order, through the calibrated camera and sheets
//   ridge   the column that was measured, through the true camera and the true sheet
//   index   what the order that was given changes over the true one
//   stray   points with no true stripe of their laser within 3 px
// and what each stage's perfection would leave of the whole: without_plane, without_ridge, without_index,
// without_stray. Of the surface, over its own places, mm:
//   fusion          the true stripe points, fused under the true outline
//   fusion_p95_abs  the same
//   fusion_cover    share of the object that this covers
// `asked` chooses sheets, correction and fusion.
Figures ErrorBudget(const CaptureTruth& truth, const DeviceGeometry& true_device,
                    const DeviceGeometry& calibrated, const ReconstructOptions& options,
                    const SurfacePoints& points, const Context& context);

}  // namespace dorsum::accuracy
