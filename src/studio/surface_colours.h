// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "jobs/reconstruct.h"
#include "report/colours.h"

namespace dorsum {

enum class ColourBy { kHeight, kOrder, kLaser, kUncertainty, kDifference, kShaded };

// How values become colours: a run of colours from low to high (mm), or a colour for each of a few numbers.
struct ColourScale {
  ColourBy by = ColourBy::kShaded;
  double low = 0.0, high = 1.0;   // mm; what lies beyond takes the colour of the end
  std::map<int, Colour> classes;  // orders or lasers

  Colour At(double value) const;  // a plain grey where there is no value (NaN), and when only shaded
};

// Height of another surface at (x, y), mm; none where it is not.
using OtherHeight = std::function<std::optional<double>(double x, double y)>;
// Keeps what it needs of the surface, which is a mesh or, where that is empty, points: there the mean of the
// points within 1 mm.
OtherHeight MakeOtherHeight(const Reconstruction& surface);

// One value for each surface point: mm, or the number of an order or a laser; NaN where there is none.
std::vector<float> PointValues(const SurfacePoints& points, ColourBy by, const OtherHeight& other);
// The same for the mesh's vertices, which take order, laser and uncertainty from the nearest surface point
// that is no more than 6 mm away.
std::vector<float> VertexValues(const Reconstruction& surface, ColourBy by, const OtherHeight& other);

// A scale that holds the values. Ends of uncertainty and difference are those of 98 % of the values, so that
// a few wild ones do not take the colours from the rest.
ColourScale MakeScale(ColourBy by, const std::vector<float>& points, const std::vector<float>& vertices);

// Errors of a difference, mm, over all values that are there.
struct DifferenceSummary {
  std::size_t compared = 0, outside = 0;
  double mean_mm = 0.0, rms_mm = 0.0;
};
DifferenceSummary Summarize(const std::vector<float>& differences);

}  // namespace dorsum
