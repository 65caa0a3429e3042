// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "jobs/design_ambiguity.h"
#include "jobs/design_combs.h"
#include "jobs/design_field.h"

namespace dorsum {

// One order of the first laser whose fan stands upright, as equations 2.2 to 2.7 and the cone have it.
struct OrderFigures {
  int order = 0;
  double described = 0.0;              // brightness over the central one's, as the description says
  double slit = 0.0;                   // the same by equation 2.2 for DesignReport::slit_um
  double angle_deg = 0.0;              // in the middle of the stripe
  double low_mm = 0.0, high_mm = 0.0;  // x on the backplane (z = 0) and at the volume's top
  bool in_view = false;                // over the hand area on the backplane
};

struct LaserFigures {
  double x_mm = 0.0;
  double baseline_mm = 0.0;        // across the stripes, camera to laser
  double triangulation_deg = 0.0;  // between the camera's and the laser's ray, at the volume's middle
  int stripes_in_view = 0;         // over the hand area on the backplane
  double unambiguous_mm = 0.0;     // see HeightAmbiguity
  bool beyond_volume = false;
  VolumeFigures volume;
};

// All that `dorsum design` says about a device.
struct DesignReport {
  DesignedDevice device;
  SurfaceAssumption surface;
  double slit_um = 0.0;            // whose envelope leaves the outermost order as bright as described
  double slit_brightest_um = 0.0;  // that sends most light into the outermost order
  std::vector<OrderFigures> orders;
  std::vector<LaserFigures> lasers;
  std::vector<CombFigures> combs;  // by height
  HeightAmbiguity ambiguity;
  Eigen::Vector2d seen_low_mm, seen_high_mm;         // what the picture shows at the volume's bottom and top
  double px_per_mm_low = 0.0, px_per_mm_high = 0.0;  // in mid-picture, across the stripes
  double points_per_cm2 = 0.0;                       // of all lasers
  double row_sigma_mm = 0.0, pooled_sigma_mm = 0.0;  // of all lasers, root mean square
  double merit = 0.0;                                // points per cm2 over pooled_sigma_mm
  std::vector<std::string> warnings;                 // one sentence each
  std::vector<std::string> explanations;             // why so few orders, in words and figures
};

DesignReport JudgeDesign(const DesignedDevice& device, const SurfaceAssumption& surface);

// Why a grating shows fewer than five stripes of a laser over the hand area, with figures; empty where it
// shows more.
std::string ExplainFewOrders(const DesignedDevice& device, int stripes_in_view);

std::string DesignToText(const DesignReport& report);
Json DesignToJson(const DesignReport& report);

}  // namespace dorsum
