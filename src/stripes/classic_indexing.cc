// SPDX-License-Identifier: Apache-2.0
#include "stripes/classic_indexing.h"

#include <cstdlib>

namespace dorsum {
namespace {

// Brightness of each order on the backplane, in its middle; beyond those seen that of the outermost.
ReferencePeak ReferencePeaks(const LaserGeometry& laser) {
  return [&laser](int order) {
    if (laser.reference.empty()) return order == 0 ? 2.0 : 1.0;
    const ReferenceStripe* nearest = &laser.reference.front();
    for (const ReferenceStripe& r : laser.reference) {
      if (std::abs(r.order - order) < std::abs(nearest->order - order)) nearest = &r;
    }
    return nearest->PeakAt(nearest->middle_v);
  };
}

}  // namespace

IndexingDiagnostics IndexClassicOne(const BackplaneOrder& backplane_order, const OrderRange& range,
                                    const ReferencePeak& reference_peak,
                                    const ClassicIndexingOptions& options, LaserStripes* stripes) {
  StripeTree tree = BuildStripeTree(stripes, options.min_shared_rows);
  IndexingDiagnostics d;
  d.laser = stripes->laser;
  d.segments = static_cast<int>(stripes->segments.size());
  d.corrections = CorrectGaps(*stripes, backplane_order, options.gaps, &tree);
  AlignToCentralStripe(tree, range, reference_peak, options.alignment, stripes);
  for (const StripeSegment& s : stripes->segments) {
    if (!s.order) ++d.left_out;
  }
  return d;
}

IndexedStripes IndexClassic(std::vector<LaserStripes> stripes, const DeviceGeometry& device, SheetModel model,
                            const ClassicIndexingOptions& options) {
  IndexedStripes out;
  for (LaserStripes& one : stripes) {
    const LaserGeometry* laser = device.FindLaser(one.laser);
    if (laser == nullptr) continue;
    const auto order_at = [&](float u, float v, double z) {
      return OrderAtHeight(device.camera, *laser, model, {u, v}, z).value_or(0.0);
    };
    const BackplaneOrder backplane = [&](float u, float v) { return order_at(u, v, 0.0); };
    const OrderRange range = [&](float u, float v) {
      return std::pair(order_at(u, v, device.min_height_mm), order_at(u, v, device.max_height_mm));
    };
    out.diagnostics.push_back(IndexClassicOne(backplane, range, ReferencePeaks(*laser), options, &one));
    out.lasers.push_back(std::move(one));
  }
  return out;
}

}  // namespace dorsum
