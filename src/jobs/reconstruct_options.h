// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/options.h"
#include "imaging/hand_mask.h"
#include "imaging/object_mask.h"
#include "imaging/stripe_mask.h"
#include "stripes/backplane_stripes.h"
#include "stripes/classic_indexing.h"
#include "stripes/classic_segments.h"
#include "stripes/joint_indexing.h"
#include "stripes/object_stripes.h"
#include "stripes/pooling.h"
#include "stripes/ridge.h"
#include "stripes/shading.h"
#include "stripes/smoothing.h"
#include "surface/height_field.h"
#include "surface/robust_fusion.h"

namespace dorsum {

// Which way each stage goes, and how. Every stage has a name of its own, so that a new way of doing one stage
// can be compared with all others left as they are (DESIGN §3).
struct ReconstructOptions {
  std::string method = "default";   // default | classic: decides every stage that says "auto"
  std::string mask = "auto";        // robust | classic
  std::string stripes = "auto";     // ridge | classic
  std::string indexing = "auto";    // joint | classic
  std::string sheets = "auto";      // cone | plane
  std::string correction = "auto";  // polynomial | none; auto: polynomial for planes
  std::string shading = "auto";     // led | none
  std::string fusion = "auto";      // robust | classic
  std::vector<int> lasers;          // use only these; empty: all

  ObjectMaskOptions object_mask;
  RidgeOptions ridge;
  PoolingOptions pooling{.max_half_rows = 12};  // the object bends, so wide windows are wrong
  JointIndexingOptions joint_indexing;
  ObjectSplitOptions object_split;
  ShadingOptions surface_shading;
  RobustFusionOptions robust_fusion;

  HandMaskOptions hand_mask;
  StripeMaskOptions stripe_mask;
  ClassicSegmentOptions segments;
  SmoothingOptions smoothing;
  BackplaneStripeOptions backplane;
  ClassicIndexingOptions classic_indexing;
  HeightFieldOptions height_field;
};

// The same with every "auto" replaced by what the method means by it.
ReconstructOptions ResolveStages(ReconstructOptions options);

// The one table of a reconstruction's options; it points into `options`, which must outlive it.
OptionTable DescribeReconstructOptions(ReconstructOptions* options);

}  // namespace dorsum
