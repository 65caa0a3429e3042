// SPDX-License-Identifier: Apache-2.0
#include "accuracy/score.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "accuracy/object_area.h"
#include "accuracy/stripe_match.h"

namespace dorsum::accuracy {
namespace {

constexpr double kWrongMm = 2.0;
constexpr double kPointStepMm = 1.5;  // true heights around a point differ by less

// A point on the object with the truth at its image point.
struct Judged {
  const SurfacePoint* point;
  cv::Vec3d truth;
  double error;
  bool right;
};

std::vector<Judged> Judge(const CaptureTruth& truth, const SurfacePoints& points) {
  std::vector<Judged> judged;
  for (const SurfacePoint& p : points) {
    const cv::Vec3d t = TruthAt(truth, p.u, p.v, kPointStepMm);
    if (std::isnan(t[2])) continue;
    const double error = p.position.z() - t[2];
    judged.push_back({&p, t, error, std::abs(error) < kWrongMm});
  }
  return judged;
}

double ShareBeyond(const CaptureTruth& truth, const SurfacePoints& points) {
  const cv::Mat1b near = ObjectArea(truth, 2);
  int outside = 0;
  for (const SurfacePoint& p : points) {
    const int u = static_cast<int>(std::nearbyint(p.u)), v = static_cast<int>(std::nearbyint(p.v));
    const bool in_image = u >= 0 && v >= 0 && u < near.cols && v < near.rows;
    if (!in_image || near(v, u) == 0) ++outside;
  }
  return static_cast<double>(outside) / static_cast<double>(points.size());
}

}  // namespace

MaskScore ScoreMask(const CaptureTruth& truth, const cv::Mat1b& mask) {
  if (mask.size() != truth.material.size()) throw std::logic_error("ScoreMask: images of two sizes");
  const cv::Mat1b object = ObjectArea(truth, 0), outside = ObjectArea(truth, 3) == 0;
  cv::Mat1b inside;
  cv::erode(object, inside, cv::Mat1b::ones(3, 3));
  const double area = cv::countNonZero(object);
  return {cv::countNonZero((inside > 0) & (mask == 0)) / area, cv::countNonZero(outside & (mask > 0)) / area};
}

std::optional<PointScore> ScorePoints(const CaptureTruth& truth, const SurfacePoints& points) {
  constexpr std::size_t kFewest = 50, kFewestOfLaser = 21;
  const std::vector<Judged> judged = Judge(truth, points);
  if (judged.size() < kFewest) return std::nullopt;
  PointScore score;
  score.points = static_cast<int>(points.size());
  score.points_on_object = static_cast<int>(judged.size());
  std::vector<double> errors, right, ratios;
  std::map<int, std::vector<double>> by_laser;
  std::vector<Eigen::Vector2d> ours, theirs;
  for (const Judged& j : judged) {
    errors.push_back(j.error);
    by_laser[j.point->laser].push_back(j.error);
    if (!j.right) continue;
    right.push_back(j.error);
    ours.emplace_back(j.point->position.head<2>());
    theirs.emplace_back(j.truth[0], j.truth[1]);
    if (j.point->sigma > 0.0F) {
      ratios.push_back(j.error / j.point->sigma);
    } else {
      ++score.sigma_bad;
    }
  }
  score.wrong = 1.0 - static_cast<double>(right.size()) / static_cast<double>(judged.size());
  score.z = Describe(errors);
  score.z_rmse_right = Rms(right);
  for (const auto& [laser, list] : by_laser) {
    if (list.size() >= kFewestOfLaser) score.z_rmse_laser[laser] = Rms(list);
  }
  if (!ratios.empty()) score.sigma_ratio = Rms(ratios);
  score.alignment = AlignInPlane(ours, theirs);
  score.xy_rmse = Rms(score.alignment.residuals);
  const StripeMatch match = MatchStripes(truth, points);
  score.complete = match.wanted == 0 ? 0.0 : static_cast<double>(match.found) / match.wanted;
  int strays = 0;
  for (const Judged& j : judged) strays += match.stray[static_cast<std::size_t>(j.point - points.data())];
  score.stray = static_cast<double>(strays) / static_cast<double>(judged.size());
  score.beyond = ShareBeyond(truth, points);
  return score;
}

Figures ToFigures(const PointScore& p, const std::optional<SurfaceScore>& surface) {
  Figures f = {{"points", p.points},       {"points_on_object", p.points_on_object},
               {"wrong", p.wrong},         {"z_rmse", p.z.rmse},
               {"z_bias", p.z.bias},       {"z_median_abs", p.z.median_abs},
               {"z_p95_abs", p.z.p95_abs}, {"z_rmse_right", p.z_rmse_right},
               {"sigma_bad", p.sigma_bad}, {"xy_rmse", p.xy_rmse},
               {"complete", p.complete},   {"stray", p.stray},
               {"beyond", p.beyond}};
  for (const auto& [laser, rmse] : p.z_rmse_laser) f["z_rmse_laser" + std::to_string(laser)] = rmse;
  if (p.sigma_ratio) f["sigma_ratio"] = *p.sigma_ratio;
  if (!surface) return f;
  f["surface_z_rmse"] = surface->z.rmse;
  f["surface_z_bias"] = surface->z.bias;
  f["surface_z_median_abs"] = surface->z.median_abs;
  f["surface_z_p95_abs"] = surface->z.p95_abs;
  f["surface_wrong"] = surface->wrong;
  f["surface_cover"] = surface->cover;
  f["surface_beyond"] = surface->beyond;
  f["surface_faces"] = surface->faces;
  return f;
}

}  // namespace dorsum::accuracy
