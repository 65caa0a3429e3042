// SPDX-License-Identifier: Apache-2.0
#include "calibration/first_estimates.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "captures/names.h"
#include "imaging/iterative_threshold.h"
#include "imaging/stage_sink.h"

namespace dorsum {

Result<DrawnLines> FindDrawnLines(const CalibrationSeries& series, const FirstEstimatesOptions& options,
                                  const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat lines_image, series.Read(kFirstEstimatesName, Channels::kGreen));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat background, series.Read(kBgNoHandName, Channels::kGreen));
  cv::Mat darker, mask;
  cv::subtract(background, lines_image, darker);
  cv::threshold(darker, mask, std::max(8.0, IterativeThreshold(darker)), 255, cv::THRESH_BINARY);
  Sink(context, "calibration/firstEstimates", mask);
  DrawnLines drawn{FindVerticalLines(mask, {}, options.lines), mask.rows};
  if (drawn.lines.empty()) {
    return BadInput(
        "no drawn lines are seen in laserFirstEstimates; capture the laser calibration plane again");
  }
  return drawn;
}

std::vector<double> PlacesOfLines(const DrawnLines& drawn, const Camera& camera) {
  std::vector<double> xs;
  for (const VerticalLine& line : drawn.lines) {
    // The row in which that happens is close to the row of the origin.
    const Eigen::Vector2d origin = Project(camera, Eigen::Vector3d::Zero());
    const double u = line.at + line.slope * (origin.y() - 0.5 * (drawn.rows - 1));
    const Ray ray = CastRay(camera, {u, origin.y()});
    if (const auto t = Intersect(ray, Plane{})) xs.push_back(ray.At(*t).x());
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

std::map<int, double> AssignFirstEstimates(const std::vector<double>& lines,
                                           const std::map<int, double>& brightest) {
  std::map<int, double> assigned;
  if (lines.size() != brightest.size()) return assigned;
  struct Pair {
    double apart = 0.0;
    int laser = 0;
    std::size_t line = 0;
  };
  std::vector<Pair> pairs;
  for (const auto& [laser, x] : brightest) {
    for (std::size_t i = 0; i < lines.size(); ++i) pairs.push_back({std::abs(lines[i] - x), laser, i});
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.apart < b.apart; });
  std::vector<char> taken(lines.size(), 0);
  for (const Pair& p : pairs) {
    if (taken[p.line] != 0 || assigned.contains(p.laser)) continue;
    taken[p.line] = 1;
    assigned[p.laser] = lines[p.line];
  }
  return assigned;
}

}  // namespace dorsum
