// SPDX-License-Identifier: Apache-2.0
#include "surface/height_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "base/parallel.h"

namespace dorsum {
namespace {

// Where a stripe crosses a grid row.
struct Crossing {
  double x = 0.0, z = 0.0, weight = 0.0;  // sums while collecting, then means
};

using Row = std::vector<Crossing>;

std::vector<Row> CollectCrossings(const SurfacePoints& points, const HeightField& field, int rows) {
  std::vector<std::map<std::tuple<int, int>, Crossing>> by_stripe(static_cast<std::size_t>(rows));
  for (const SurfacePoint& p : points) {
    const long r = std::lround((p.position.y() - field.origin_mm.y()) / field.pitch_mm);
    if (r < 0 || r >= rows) continue;
    Crossing& c = by_stripe[static_cast<std::size_t>(r)][{p.laser, p.segment}];
    c.x += p.position.x();
    c.z += p.position.z();
    c.weight += 1.0;
  }
  std::vector<Row> out(by_stripe.size());
  for (std::size_t r = 0; r < by_stripe.size(); ++r) {
    for (const auto& [stripe, c] : by_stripe[r]) out[r].push_back({c.x / c.weight, c.z / c.weight, c.weight});
    std::stable_sort(out[r].begin(), out[r].end(),
                     [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  }
  return out;
}

// Drops crossings far from the median of those around them (this row and the next ones, up to two stripes
// away).
int DropOutliers(const std::vector<Row>& rows, std::size_t r, const HeightFieldOptions& options, Row* kept) {
  int dropped = 0;
  std::vector<double> around;
  for (const Crossing& c : rows[r]) {
    around.clear();
    for (std::size_t q = r >= 2 ? r - 2 : 0; q <= std::min(r + 2, rows.size() - 1); ++q) {
      for (const Crossing& other : rows[q]) {
        if (std::abs(other.x - c.x) <= options.max_gap_mm) around.push_back(other.z);
      }
    }
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::nth_element(around.begin(), middle, around.end());
    const double slack =
        std::tan(options.max_slope_deg * std::numbers::pi / 180.0) * 0.5 * options.max_gap_mm;
    if (std::abs(c.z - *middle) >
        std::max(options.max_outlier_mm, around.size() < 8 ? slack : options.max_outlier_mm)) {
      ++dropped;
    } else {
      kept->push_back(c);
    }
  }
  return dropped;
}

bool SeenOnObject(const Camera& camera, const cv::Mat& mask, const Eigen::Vector3d& p) {
  const Eigen::Vector2d pixel = Project(camera, p);
  const auto u = static_cast<int>(std::lround(pixel.x())), v = static_cast<int>(std::lround(pixel.y()));
  return u >= 0 && v >= 0 && u < mask.cols && v < mask.rows && mask.at<std::uint8_t>(v, u) != 0;
}

// Fills the grid columns from one crossing to the next.
void FillBetween(const Crossing& a, const Crossing& b, double y, const Camera& camera, const cv::Mat& mask,
                 const HeightField& field, float* row) {
  const int begin = static_cast<int>(std::ceil((a.x - field.origin_mm.x()) / field.pitch_mm));
  const int end = static_cast<int>(std::floor((b.x - field.origin_mm.x()) / field.pitch_mm));
  for (int c = std::max(0, begin); c <= std::min(field.z.cols - 1, end); ++c) {
    const double x = field.origin_mm.x() + c * field.pitch_mm;
    const double t = b.x > a.x ? (x - a.x) / (b.x - a.x) : 0.0;
    const double z = a.z + t * (b.z - a.z);
    if (SeenOnObject(camera, mask, {x, y, z})) row[c] = static_cast<float>(z);
  }
}

}  // namespace

HeightField FuseHeightField(const SurfacePoints& points, const Camera& camera, const cv::Mat& mask,
                            const HeightFieldOptions& options, const Context& context) {
  HeightField field;
  field.pitch_mm = options.pitch_mm;
  if (points.empty()) return field;
  constexpr double kLimit = 1000.0;  // mm; a point further away is no part of a hand
  Eigen::Vector2d low(kLimit, kLimit), high(-kLimit, -kLimit);
  for (const SurfacePoint& p : points) {
    const Eigen::Vector2d xy = p.position.head<2>();
    if (xy.cwiseAbs().maxCoeff() > kLimit) continue;
    low = low.cwiseMin(xy);
    high = high.cwiseMax(xy);
  }
  if (low.x() > high.x()) return field;
  // Origins on whole multiples of the pitch, so that the fields of repeats lie on the same grid.
  field.origin_mm = (low / field.pitch_mm).array().floor() * field.pitch_mm;
  const int columns = static_cast<int>(std::ceil((high.x() - field.origin_mm.x()) / field.pitch_mm)) + 1;
  const int rows = static_cast<int>(std::ceil((high.y() - field.origin_mm.y()) / field.pitch_mm)) + 1;
  field.z = cv::Mat1f(rows, columns, std::numeric_limits<float>::quiet_NaN());

  const std::vector<Row> crossings = CollectCrossings(points, field, rows);
  std::vector<int> dropped(crossings.size(), 0);
  const double max_slope = std::tan(options.max_slope_deg * std::numbers::pi / 180.0);
  ParallelFor(context, 0, rows, [&](std::int64_t r) {
    const auto index = static_cast<std::size_t>(r);
    Row kept;
    dropped[index] = DropOutliers(crossings, index, options, &kept);
    auto* row = field.z.ptr<float>(static_cast<int>(r));
    const double y = field.origin_mm.y() + static_cast<double>(r) * field.pitch_mm;
    for (std::size_t i = 1; i < kept.size(); ++i) {
      const double dx = kept[i].x - kept[i - 1].x, dz = std::abs(kept[i].z - kept[i - 1].z);
      // Two lasers' stripes may all but coincide: then their noise alone makes a steep slope.
      if (dx > options.max_gap_mm || dz > max_slope * std::max(dx, 2.0 * options.pitch_mm)) continue;
      FillBetween(kept[i - 1], kept[i], y, camera, mask, field, row);
    }
  });
  for (const int d : dropped) field.left_out += d;
  return field;
}

}  // namespace dorsum
