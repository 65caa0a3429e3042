// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/calibration.h"
#include "stripes/central_alignment.h"
#include "stripes/gap_correction.h"
#include "stripes/stripes.h"

namespace dorsum {

struct ClassicIndexingOptions {
  int min_shared_rows = 4;  // rows in which two stripes must stand side by side to be neighbours
  GapCorrectionOptions gaps;
  CentralAlignmentOptions alignment;
};

// The document's indexing (§3.5: Algorithms 1 and 2 and the alignment to the brightest stripe), each laser
// by itself. `model` says which sheets `device` is asked for. Lasers that the device does not know are left
// out.
IndexedStripes IndexClassic(std::vector<LaserStripes> stripes, const DeviceGeometry& device, SheetModel model,
                            const ClassicIndexingOptions& options);

// The same for one laser whose geometry is given by functions alone: on the background, before sheets are
// known, and in tests. Returns the diagnostics.
IndexingDiagnostics IndexClassicOne(const BackplaneOrder& backplane_order, const OrderRange& range,
                                    const ReferencePeak& reference_peak,
                                    const ClassicIndexingOptions& options, LaserStripes* stripes);

}  // namespace dorsum
