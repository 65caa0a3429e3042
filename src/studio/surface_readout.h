// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "studio/surface_measurer.h"

namespace dorsum {

// What is known of the surface, of the places that were chosen and of what lies between them, in lines; and
// what to do next. `difference` is to `other`, or none.
QString SurfaceReadout(const SurfaceMeasurer& measurer, const DifferenceSummary* difference,
                       const QString& other);

}  // namespace dorsum
