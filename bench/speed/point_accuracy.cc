// SPDX-License-Identifier: Apache-2.0
#include "speed/point_accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "accuracy/statistics.h"

namespace dorsum::speed {
namespace {

using accuracy::TrueStripe;

constexpr double kFoundPx = 1.5, kLitIrradiance = 0.02;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Columns of a stripe's order in a row; a row that meets a stripe twice has two.
using Columns = std::map<std::pair<int, int>, std::vector<double>>;

std::optional<double> NearestColumn(const Columns& columns, int order, int row, double u) {
  const auto found = columns.find({order, row});
  if (found == columns.end()) return std::nullopt;
  return *std::min_element(found->second.begin(), found->second.end(),
                           [u](double a, double b) { return std::abs(a - u) < std::abs(b - u); });
}

// Of a stripe at one of its points, columns by row; 0 where a neighbouring row shows no more of it.
double SlopeAt(const Columns& columns, const TrueStripe& s) {
  constexpr double kSteepest = 3.0;
  const auto above = NearestColumn(columns, s.order, s.row - 1, s.u);
  const auto below = NearestColumn(columns, s.order, s.row + 1, s.u);
  if (!above || !below) return 0.0;
  const double slope = 0.5 * (*below - *above);
  return std::abs(slope) < kSteepest ? slope : 0.0;
}

// The share that was found, and the errors where both found something.
void Summarise(const std::vector<double>& own, const std::vector<double>& other, const std::string& name,
               Measured* out) {
  double found = 0.0;
  std::vector<double> both;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (std::isnan(own[i])) continue;
    found += 1.0;
    if (!std::isnan(other[i])) both.push_back(own[i]);
  }
  const accuracy::ErrorStatistics errors = accuracy::Describe(both);
  (*out)[name + "found"] = own.empty() ? 0.0 : found / static_cast<double>(own.size());
  (*out)[name + "rms_px"] = errors.rmse;
  (*out)[name + "median_px"] = errors.median_abs;
}

}  // namespace

std::vector<double> ErrorsAgainst(const std::vector<TrueStripe>& truth,
                                  const std::vector<cv::Point2f>& points) {
  Columns columns;
  for (const TrueStripe& s : truth) columns[{s.order, s.row}].push_back(s.u);
  std::map<int, std::vector<cv::Point2f>> by_row;
  for (const cv::Point2f& p : points) by_row[cvRound(p.y)].push_back(p);
  std::vector<double> errors;
  errors.reserve(truth.size());
  for (const TrueStripe& s : truth) {
    const double slope = SlopeAt(columns, s);
    double nearest = kNan;
    for (const cv::Point2f& p : by_row[s.row]) {
      const double error =
          static_cast<double>(p.x) - s.u - slope * (static_cast<double>(p.y) - static_cast<double>(s.row));
      if (std::abs(error) < kFoundPx && !(std::abs(nearest) <= std::abs(error))) nearest = error;
    }
    errors.push_back(nearest);
  }
  return errors;
}

void DetectorComparison::Add(const std::vector<TrueStripe>& truth, const std::vector<cv::Point2f>& ours,
                             const std::vector<cv::Point2f>& theirs) {
  const std::vector<double> own = ErrorsAgainst(truth, ours), other = ErrorsAgainst(truth, theirs);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!(truth[i].irradiance > kLitIrradiance)) continue;
    Errors& kind = accuracy::CaptureTruth::IsObject(truth[i].material) ? object_ : backplane_;
    kind.ours.push_back(own[i]);
    kind.theirs.push_back(other[i]);
  }
}

Measured DetectorComparison::Summary() const {
  Measured out;
  Summarise(object_.ours, object_.theirs, "object/ours/", &out);
  Summarise(object_.theirs, object_.ours, "object/theirs/", &out);
  Summarise(backplane_.ours, backplane_.theirs, "backplane/ours/", &out);
  Summarise(backplane_.theirs, backplane_.ours, "backplane/theirs/", &out);
  return out;
}

}  // namespace dorsum::speed
