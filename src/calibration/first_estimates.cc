// SPDX-License-Identifier: Apache-2.0
#include "calibration/first_estimates.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "captures/image_file.h"
#include "captures/names.h"
#include "imaging/iterative_threshold.h"
#include "imaging/stage_sink.h"

namespace dorsum {

Result<std::vector<double>> FindFirstEstimates(const CalibrationSeries& series, const Camera& camera,
                                               const FirstEstimatesOptions& options, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat lines_image, series.Read(kFirstEstimatesName));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat background, series.Read(kBgNoHandName));
  cv::Mat darker, mask;
  cv::subtract(GreenChannel(background), GreenChannel(lines_image), darker);
  cv::threshold(darker, mask, std::max(8.0, IterativeThreshold(darker)), 255, cv::THRESH_BINARY);
  Sink(context, "calibration/firstEstimates", mask);
  const std::vector<VerticalLine> lines = FindVerticalLines(mask, {}, options.lines);
  std::vector<double> xs;
  for (const VerticalLine& line : lines) {
    // Where the line crosses y = 0: the row in which that happens is close to the row of the origin.
    const Eigen::Vector2d origin = Project(camera, Eigen::Vector3d::Zero());
    const double u = line.at + line.slope * (origin.y() - 0.5 * (mask.rows - 1));
    const Ray ray = CastRay(camera, {u, origin.y()});
    if (const auto t = Intersect(ray, Plane{})) xs.push_back(ray.At(*t).x());
  }
  if (xs.empty()) {
    return BadInput(
        "no drawn lines are seen in laserFirstEstimates; capture the laser calibration plane again");
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

std::map<int, double> AssignFirstEstimates(const std::vector<double>& lines,
                                           const std::map<int, double>& brightest) {
  std::map<int, double> assigned;
  if (lines.size() != brightest.size()) return assigned;
  double forward = 0.0, backward = 0.0;
  std::size_t i = 0;
  for (const auto& [laser, x] : brightest) {
    forward += std::abs(lines[i] - x);
    backward += std::abs(lines[lines.size() - 1 - i] - x);
    ++i;
  }
  i = 0;
  for (const auto& [laser, x] : brightest) {
    assigned[laser] = forward <= backward ? lines[i] : lines[lines.size() - 1 - i];
    ++i;
  }
  return assigned;
}

}  // namespace dorsum
