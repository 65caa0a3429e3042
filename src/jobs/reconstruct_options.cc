// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_options.h"

namespace dorsum {

OptionTable DescribeReconstructOptions(ReconstructOptions* o) {
  OptionTable t;
  t.Add("mask", &o->mask, {"auto", "robust", "classic"}, "how the object is found in the image (§3.4)");
  t.Add("stripes", &o->stripes, {"auto", "ridge", "classic"}, "how stripes are located (§3.4)");
  t.Add("indexing", &o->indexing, {"auto", "joint", "classic"}, "how stripes get their orders (§3.5)");
  t.Add("shading", &o->shading, {"auto", "led", "none"},
        "whether the surface's brightness is taken off the stripes' centres (ridges)");
  t.Add("sheets", &o->sheets, {"auto", "cone", "plane"}, "model of a light sheet (§3.6)");
  t.Add("correction", &o->correction, {"auto", "polynomial", "none"},
        "surface error correction of plane sheets (3.9)");
  t.Add("fusion", &o->fusion, {"auto", "robust", "classic"}, "how the lasers are merged");
  t.Add("indexing-own-margin", &o->joint_indexing.min_own_margin, 0.0, 1000.0,
        "a stripe keeps its order where any other costs this much more (joint)");
  t.Add("indexing-surface-margin", &o->joint_indexing.min_surface_margin, 0.0, 1000.0,
        "the same for a whole surface");
  t.Add("fusion-beyond-mm", &o->robust_fusion.max_beyond_mm, 0.0, 50.0,
        "how far the surface goes on beyond the last points, mm (robust)");
  t.Add("fusion-gap-mm", &o->robust_fusion.max_gap_mm, 1.0, 100.0,
        "widest gap between points that closes, mm (robust)");
  t.Add("fusion-outlier-mm", &o->robust_fusion.outlier_mm, 0.1, 50.0,
        "a point further from the surface than this, mm, and than … (robust)");
  t.Add("fusion-outlier-sigmas", &o->robust_fusion.outlier_sigmas, 1.0, 100.0,
        "… that many of its sigma is left out (robust)");
  t.Add("mask-open-px", &o->hand_mask.open_px, 1, 99, "side of the mask's opening, px");
  t.Add("mask-min-contrast", &o->hand_mask.min_contrast, 0.0, 255.0,
        "least contrast of the object, 255ths of the background");
  t.Add("stripe-block-px", &o->stripe_mask.block_px, 3, 999, "window of the stripes' adaptive threshold, px");
  t.Add("stripe-offset", &o->stripe_mask.offset, 0.0, 255.0,
        "edge response above its local mean, grey values");
  t.Add("stripe-median-px", &o->stripe_mask.median_px, 1, 15, "side of the stripe mask's median, px");
  t.Add("stripe-min-area-px", &o->segments.min_area_px, 1, 100000, "smallest stripe region, px");
  t.Add("stripe-min-rows", &o->segments.min_rows, 1, 10000, "shortest stripe, px");
  t.Add("smooth-rows", &o->smoothing.half_window_rows, 0, 1000, "rows on either side smoothed together, px");
  t.Add("smooth-max-step-px", &o->smoothing.max_step_px, 0.1, 100.0, "jump that parts a stripe, px");
  t.Add("gap-spacings", &o->classic_indexing.gaps.max_spacings, 1.0, 3.0,
        "V of Algorithm 2, in usual spacings");
  t.Add("central-contrast", &o->classic_indexing.alignment.min_contrast, 0.0, 1.0,
        "share of the central order's contrast that a level must show to be central");
  t.Add("pitch-mm", &o->height_field.pitch_mm, 0.1, 5.0,
        "grid of the height field, mm; robust fusion's mesh has a node each 1.25 of it");
  t.Add("max-gap-mm", &o->height_field.max_gap_mm, 0.5, 50.0,
        "widest gap between stripes that is bridged, mm");
  t.Add("max-slope-deg", &o->height_field.max_slope_deg, 10.0, 89.0,
        "steepest surface between stripes, degrees");
  return t;
}

ReconstructOptions ResolveStages(ReconstructOptions o) {
  const bool classic = o.method == "classic";
  const auto decide = [&](std::string* stage, const char* ours, const char* theirs) {
    if (*stage == "auto") *stage = classic ? theirs : ours;
  };
  decide(&o.mask, "robust", "classic");
  decide(&o.stripes, "ridge", "classic");
  decide(&o.indexing, "joint", "classic");
  decide(&o.shading, "led", "none");
  decide(&o.sheets, "cone", "plane");
  if (o.correction == "auto") o.correction = o.sheets == "plane" ? "polynomial" : "none";
  decide(&o.fusion, "robust", "classic");
  return o;
}

}  // namespace dorsum
