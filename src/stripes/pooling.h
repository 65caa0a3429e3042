// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/context.h"
#include "stripes/brightness_pull.h"
#include "stripes/row_noise.h"
#include "stripes/stripes.h"

namespace dorsum {

struct PoolingOptions {
  int min_half_rows = 3;    // smallest window: this many rows to either side, 2 to 20
  int max_half_rows = 48;   // largest, rows
  double confidence = 2.7;  // windows grow while their estimates agree within this many standard deviations
  // A window is chosen by what it shows, so its estimate errs by more than its own deviation says: by this
  // much on boxes and hands of devices that choices were made on; 1 and more.
  double choice_error = 1.08;
  // For who reads only some rows: this many to the next, counted from `first_row` of each segment. The others
  // lend their noise and stay single.
  int every_rows = 1, first_row = 0;
  RowNoiseOptions noise = {};
  BrightnessPullOptions pull = {};
};

// Local quadratic regression of u over the rows of each segment, with the largest window that the noise does
// not contradict (intersection of confidence intervals: Lepski 1991; Goldenshluger and Nemirovski 1997). A
// window never leaves its segment. Speckle and compression make neighbouring rows err alike: the rows'
// autocorrelation and the scale of their formal deviations are measured from residuals, and `sd_px` is the
// pooled estimate's own with both; `row_u` and `row_sd_px` keep the single row. Points of segments too short
// to pool stay as they are.
LaserStripes PoolAlongStripes(LaserStripes stripes, const PoolingOptions& options, const Context& context);

}  // namespace dorsum
