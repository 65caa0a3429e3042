// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/options.h"
#include "imaging/hand_mask.h"
#include "imaging/stripe_mask.h"
#include "stripes/backplane_stripes.h"
#include "stripes/classic_indexing.h"
#include "stripes/classic_segments.h"
#include "stripes/smoothing.h"
#include "surface/height_field.h"

namespace dorsum {

// Which way each stage goes, and how. Every stage has a name of its own, so that a new way of doing one stage
// can be compared with all others left as they are (DESIGN §3).
struct ReconstructOptions {
  std::string mask = "classic";
  std::string stripes = "classic";
  std::string indexing = "classic";
  std::string sheets = "plane";
  std::string correction = "polynomial";  // or "none"
  std::string fusion = "classic";
  std::vector<int> lasers;  // use only these; empty: all

  HandMaskOptions hand_mask;
  StripeMaskOptions stripe_mask;
  ClassicSegmentOptions segments;
  SmoothingOptions smoothing;
  BackplaneStripeOptions backplane;
  ClassicIndexingOptions classic_indexing;
  HeightFieldOptions height_field;
};

// The one table of a reconstruction's options; it points into `options`, which must outlive it.
OptionTable DescribeReconstructOptions(ReconstructOptions* options);

}  // namespace dorsum
