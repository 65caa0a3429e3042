// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/calibration.h"
#include "stripes/stripes.h"

namespace dorsum {

struct BackplaneStripeOptions {
  double max_distance_px = 1.2;  // from the reference stripe, px
  double min_brightness = 0.6;   // share of the reference stripe's brightness, 0 to 1
  double max_brightness = 1.6;   // the same from above
  int window_rows = 9;  // rows over which brightness is averaged, since speckle makes single rows uncertain
  double remnant_distance_px =
      6.0;                // how far a shadow's edge can push a short piece off the reference stripe, px
  int remnant_rows = 40;  // longest such piece, px
  int vote_rows = 6;      // rows above and below in which the stripes beside a point are asked
  double vote_columns_px =
      110.0;  // and columns to either side, px; more than one spacing of one laser's stripes
  double vote_distance_px = 3.0;  // a dimmer stripe this close to a reference stripe speaks against, px
};

struct BackplaneSplit {
  LaserStripes object;  // what is left, segments parted where pieces were taken out
  std::vector<StripePoint>
      backplane;  // what lies where the empty backplane shows a stripe, as bright as there
};

// Takes the pieces of stripes that lie on the backplane out of the stripes found inside a mask, all lasers
// together. A mask made from the LED image holds the shadow beside the hand too, which can be as dark as
// skin; the reference stripes (§3.2) tell the two apart: in a shadow of the LEDs a stripe stays where it is
// without a hand, and as bright. An object's stripe can meet a reference stripe by chance, where the object's
// height shifts stripes by one whole spacing; then the stripes beside it meet theirs too, but are dimmer, and
// outvote it. One entry per entry of `stripes`.
std::vector<BackplaneSplit> SplitBackplane(const std::vector<LaserStripes>& stripes,
                                           const DeviceGeometry& device, int min_rows,
                                           const BackplaneStripeOptions& options);

}  // namespace dorsum
