// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "stripes/profile_fit.h"
#include "stripes/stripes.h"

namespace dorsum {

struct CutStripeOptions {
  int half_rows = 3;  // rows to either side whose profiles are averaged to judge a row
  // A stripe is cut where its width at half the peak is below this share of the segment's usual width and one
  // flank is shorter than the other by `max_flank_ratio`; where that alone is striking; or where
  // the width alone is, and the whole run of narrow rows leans to one side or fades out at the segment's
  // end. All 0 to 1.
  double max_width_ratio = 0.8, max_flank_ratio = 0.8;
  double steep_flank_ratio = 0.45, slim_width_ratio = 0.7, leaning_flank_ratio = 0.935, fading_ratio = 0.6;
  double whole_width_ratio = 0.96;  // the cut goes on along the stripe until the width is this again, 0 to 1
  double min_inside_px = 0.8;       // a centre closer to where the light ends is not on the surface, px
  double amplitude_share = 0.2;  // how far a cut row's amplitude may be from its neighbours', one deviation
  double margin_px = 1.5;        // pixels next to the edge that the blur has darkened, px
};

// Mends the rows where a stripe is cut by an edge along it: the edge of a box or a fingertip leaves only one
// flank of the profile, and the peak is not the sheet's centre. Such rows are known by a narrow profile with
// one steep flank; their centre is fitted again to the intact flank alone, with the width held that the
// segment has elsewhere. Rows whose centre then lies at or beyond the edge are taken out: the sheet's middle
// misses the surface. `usual_width_px` stands in for segments that are cut throughout. Segments are not
// parted here.
LaserStripes MendCutStripes(const cv::Mat& green, const LaserStripes& stripes, const NoiseModel& noise,
                            double usual_width_px, const ProfileFitOptions& fit,
                            const CutStripeOptions& options, const Context& context);

}  // namespace dorsum
