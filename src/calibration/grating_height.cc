// SPDX-License-Identifier: Apache-2.0
#include "calibration/grating_height.h"

#include <algorithm>
#include <set>
#include <string>

namespace dorsum {
namespace {

std::set<int> Orders(const PlaneStripes& stripes) {
  std::set<int> orders;
  for (const int index : stripes.index)
    orders.insert(index - stripes.index[static_cast<std::size_t>(stripes.central)]);
  return orders;
}

}  // namespace

Result<GratingHeight> EstimateGratingHeight(const PlaneStripes& further, const PlaneStripes& closer,
                                            double object_height_mm, int laser) {
  const std::set<int> far = Orders(further), near = Orders(closer);
  std::vector<int> both;
  std::set_intersection(far.begin(), far.end(), near.begin(), near.end(), std::back_inserter(both));
  const std::string who = "laser " + std::to_string(laser);
  if (both.size() < 3) {
    return BadInput("fewer than three stripes of " + who + " are seen at both distances; capture laser" +
                    std::to_string(laser) + "CalFurther and laser" + std::to_string(laser) +
                    "CalCloser again");
  }
  GratingHeight g;
  g.from_order = both.front();
  g.to_order = both.back();
  g.spacing_further_mm = MeanSpacing(further, g.from_order, g.to_order);
  g.spacing_closer_mm = MeanSpacing(closer, g.from_order, g.to_order);
  if (g.spacing_closer_mm >= 0.999 * g.spacing_further_mm) {
    return BadInput("the stripes of " + who +
                    " are not closer together on the calibration object than on the backplane; "
                    "are the Closer and Further images swapped?");
  }
  g.height_mm = object_height_mm / (1.0 - g.spacing_closer_mm / g.spacing_further_mm);
  return g;
}

}  // namespace dorsum
