// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "jobs/design_point.h"

namespace dorsum {

// The reverse question: which grating, how many orders, which baseline, laser places and slit serve a hand of
// a given size best. What the description says of camera, light, heights and number of lasers stands.
struct DesignSearch {
  // What can be bought, lines/mm.
  std::vector<double> gratings = {50, 70, 80, 100, 120, 150, 200, 300, 500, 600, 1000};
  std::vector<double> grating_range;                 // lowest and highest of gratings made to order, too
  std::vector<double> baselines_mm = {60.0, 240.0};  // lowest and highest, 10 to 1000
  std::vector<double> camera_heights_mm = {250.0, 600.0};  // lowest and highest, 100 to 3000
  double least_pitch_mm = 10.0;        // between neighbouring lasers: their housings, 1 to 200
  double least_unambiguous_mm = 30.0;  // of each laser alone (HeightAmbiguity), 1 to 500
  double least_coverage = 0.9;    // share of the volume over the hand area that each laser lights, in view
  double least_separation = 8.0;  // between neighbouring stripes, in standard deviations of their width
  int best = 5;                   // how many designs to keep, 1 to 50
};

// One design that meets the constraints.
struct SearchHit {
  DeviceDescription description;
  double pitch_mm = 0.0, baseline_mm = 0.0, slit_um = 0.0;
  double spacing_mm = 0.0;  // of one laser on the backplane
  double unambiguous_mm = 0.0, coverage = 0.0;
  double central_efficiency =
      0.0;  // share of a laser's light in its central order: what a slit of this width costs
  double points_per_cm2 = 0.0, pooled_sigma_mm = 0.0;
  double merit = 0.0;  // what is made greatest: points per cm2 over the expected error in mm
};

struct SearchResult {
  std::vector<SearchHit> hits;       // by falling merit, the best one of each grating
  std::vector<std::string> refused;  // one sentence for each grating that serves not
};

// Tries every grating with every baseline (10 mm apart) at the lowest camera that sees the hand area through
// the whole volume. Lasers stand as close as they may and interleave best over the volume; the orders are
// those that the hand area needs; the slit is the one that sends most light into the outermost. An answer of
// no where nothing meets the constraints, with what came nearest.
Result<SearchResult> SearchDesigns(const DeviceDescription& base, const Eigen::Vector2d& hand_mm,
                                   const SurfaceAssumption& surface, const DesignSearch& search,
                                   const Context& context);

// The distance between neighbouring lasers, from `least` to a spacing more (at least 30 mm), whose combs
// leave the smallest gaps over the working volume, on average, and seldom lie on one another.
double BestPitch(const DeviceDescription& description, double least_mm);

}  // namespace dorsum
