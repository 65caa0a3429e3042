// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "stripes/cut_stripes.h"
#include "stripes/profile_fit.h"
#include "stripes/ridge_detection.h"
#include "stripes/ridge_survey.h"
#include "stripes/segment_linking.h"
#include "stripes/stripes.h"

namespace dorsum {

struct RidgeOptions {
  double width_px = 0.0;  // of the stripes' profile, one standard deviation, px; 0: taken from the image
  RidgeDetectionOptions detection;  // its width_px is set from the above
  ProfileFitOptions fit;
  SegmentLinkingOptions linking;
  CutStripeOptions cut;
  double max_width_ratio = 4.0;  // a profile this much wider than the image's usual one is no stripe
  // A segment ends where its amplitude has fallen below this share of what the rows before had, 0 to 1.
  double end_share = 0.6;
  double far_end_share = 0.45;  // the same against their plain mean
  // Least sum of a segment's amplitudes over its rows, in standard deviations of a dark pixel.
  double min_evidence = 100.0;
  int end_rows = 6;  // rows before the end that give the usual amplitude
  // Speckle and compression make neighbouring pixels err alike, so a fit's formal deviation is too small; the
  // scatter along the stripe tells by how much. Whoever pools the rows finds that out again, and needs it
  // not.
  bool scale_deviations = true;
};

// Every stripe in every image row, from the image alone: the stripes' usual width and the noise against the
// grey value are measured on a part of the rows, stripes are found by a matched filter with evidence from
// neighbouring rows, and each row's centre comes from a fit of its own. `u` and `sd_px` are the single row's,
// `peak` is the amplitude above the surroundings, grey values, 255 at most, `width` the profile's standard
// deviation. Points come by segment, one per row at most. `green` is CV_8UC1; `region` CV_8UC1 (only
// candidates on its non-zero pixels are looked at) or empty. Takes the place of §3.4's edge kernel and the
// region boundary of Algorithm 1. `noise`, if given, gets the picture's noise model.
LaserStripes FindRidges(const cv::Mat& green, const cv::Mat& region, int laser, const RidgeOptions& options,
                        const Context& context, NoiseModel* noise = nullptr);

// The same with what SurveyRidges() found, which may have looked at more of the picture than `region`.
LaserStripes FindRidges(const cv::Mat& green, const cv::Mat& region, int laser, const RidgeSurvey& survey,
                        const RidgeOptions& options, const Context& context);

}  // namespace dorsum
