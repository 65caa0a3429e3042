// SPDX-License-Identifier: Apache-2.0
#include "jobs/laser_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/median.h"

namespace dorsum {
namespace {

// How far two lasers put the object apart along one axis, mm: each against the others, in opposite
// directions, and both known well. A plane says nothing about its own directions, so a single laser's shift
// is no proof.
double ShiftBetweenLasers(const std::vector<LaserConsistency>& lasers, int axis) {
  // Along z it takes more, since a wrong order is looked for; every surface tells heights well. A shift that
  // is known badly must stand out all the more.
  const double least = axis == 2 ? 1.0 : 0.3;
  constexpr double kGoodSd = 0.4;
  // A flat object tells heights alone: what its edges say of the rest is worth less than it looks.
  constexpr double kTelling = 0.3;
  std::vector<double> sds;
  for (const LaserConsistency& one : lasers) {
    if (one.samples > 0) sds.push_back(one.shift_sd_mm[axis]);
  }
  if (Median(std::move(sds)) > kTelling) return 0.0;
  double up = 0.0, down = 0.0;
  for (const LaserConsistency& one : lasers) {
    const double shift = one.shift_mm[axis], sd = one.shift_sd_mm[axis];
    const double significance = sd > kGoodSd ? 6.0 : 4.0;
    if (one.samples == 0 || std::abs(shift) < std::max(least, significance * sd)) continue;
    up = std::max(up, shift);
    down = std::min(down, shift);
  }
  return up > 0.0 && down < 0.0 ? up - down : 0.0;
}

}  // namespace

Status CheckAgreement(const std::vector<LaserConsistency>& lasers, const DeviceGeometry& device) {
  const double beside = std::max(ShiftBetweenLasers(lasers, 0), ShiftBetweenLasers(lasers, 1));
  const double above = ShiftBetweenLasers(lasers, 2);
  char text[256];
  if (above > 1.0) {
    std::snprintf(
        text, sizeof text,
        "the lasers put the object at heights that differ by %.1f mm: it reaches out of the working volume "
        "of %.0f to %.0f mm, or moved while it was captured; place it lower and capture again",
        above, device.min_height_mm, device.max_height_mm);
    return BadInput(text);
  }
  if (beside == 0.0 && above == 0.0) return {};
  const double moved = std::max(beside, above);
  constexpr double kFar = 5.0;  // mm in the second of a capture; wrong orders put lasers apart by more
  if (moved > kFar) {
    std::snprintf(
        text, sizeof text,
        "the lasers see the object at places that differ by %.1f mm: it moved while it was captured, or "
        "reaches out of the working volume of %.0f to %.0f mm; place it lower, keep still and capture "
        "again",
        moved, device.min_height_mm, device.max_height_mm);
    return BadInput(text);
  }
  std::snprintf(
      text, sizeof text,
      "the object moved by about %.1f mm while it was captured, since the lasers see it at different "
      "places; keep still and capture again",
      moved);
  return BadInput(text);
}

}  // namespace dorsum
