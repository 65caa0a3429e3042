// SPDX-License-Identifier: Apache-2.0
#include "calibration/central_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dorsum {

const SheetPicture* FindPicture(const std::vector<SheetPicture>& pictures, int laser,
                                const std::string& series) {
  for (const SheetPicture& p : pictures) {
    if (p.laser == laser && p.series == series) return &p;
  }
  return nullptr;
}

std::map<int, double> CentralPlaces(const CalibrationSeries& series, const Camera& camera,
                                    const std::vector<SheetPicture>& pictures,
                                    const std::optional<DrawnLines>& drawn, const BundleOptions& options,
                                    std::vector<std::string>* warnings) {
  std::map<int, double> brightest;
  std::map<int, double> spacing;
  for (std::size_t i = 0; i < series.lasers.size(); ++i) {
    const SheetPicture* picture = FindPicture(pictures, static_cast<int>(i), "backplane");
    const std::vector<StripeLine> lines = LinesOnPlane(camera, picture->stripes, 0.0, options.start);
    if (lines.size() < 2) continue;
    const auto best = std::max_element(lines.begin(), lines.end(),
                                       [](const auto& a, const auto& b) { return a.strength < b.strength; });
    brightest[series.lasers[i]] = best->at;
    spacing[series.lasers[i]] = (lines.back().at - lines.front().at) / static_cast<double>(lines.size() - 1);
  }
  const std::vector<double> lines = drawn ? PlacesOfLines(*drawn, camera) : std::vector<double>();
  std::map<int, double> places = AssignFirstEstimates(lines, brightest);
  if (places.empty()) {
    warnings->push_back("laserFirstEstimates shows " + std::to_string(lines.size()) + " lines for " +
                        std::to_string(series.lasers.size()) +
                        " lasers; the brightest stripe of each laser is taken as its central one");
    return brightest;
  }
  for (const auto& [laser, x] : places) {
    if (std::abs(x - brightest[laser]) < 0.5 * spacing[laser]) continue;
    warnings->push_back(
        "laser " + std::to_string(laser) +
        ": the brightest stripe is not the one nearest to its drawn line; the drawn line decides");
  }
  return places;
}

}  // namespace dorsum
