// SPDX-License-Identifier: Apache-2.0
#include "surface/laser_consistency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "base/median.h"
#include "base/parallel.h"
#include "surface/border_distance.h"
#include "surface/patches.h"

namespace dorsum {
namespace {

constexpr int kBins = 5;  // of the distance to the nearest other stripe
// A surface that follows its samples leaves residuals that are smaller than their errors.
constexpr double kResidualsToErrors = 2.0;

// One sample against the surface of the other lasers.
struct Residual {
  Eigen::Vector3d normal;
  double e = 0.0;      // mm along the normal
  double sigma = 0.0;  // of e, from the sample alone
  int bin = 0;
  std::size_t patch = 0;
};

// What the comparisons of all lasers share.
struct Scene {
  const std::vector<PlateSample>& samples;
  const std::vector<std::uint8_t>& lasers;
  std::span<const PlateGrid> grids;
  PlateStack stack;  // without samples
  const PlateOptions& plate;
  cv::Mat1f rim;  // at the nodes
  const RayField& rays;
  Patches patches;
  const LaserConsistencyOptions& options;
};

// The node that a sample lies next to, if the lattice has it.
std::optional<cv::Point> NearestNode(const PlateSample& s, const PlateLattice& l) {
  const long c = std::lround((s.u - l.u0) / l.step_px), r = std::lround((s.v - l.v0) / l.step_px);
  if (c < 0 || r < 0 || c >= l.active.cols || r >= l.active.rows) return std::nullopt;
  return cv::Point(static_cast<int>(c), static_cast<int>(r));
}

// Squared distance in lattice steps to the nearest sample of any other laser, at most `reach` squared.
cv::Mat1w SquaredDistanceToOthers(const Scene& scene, int laser, int reach) {
  const PlateLattice& l = scene.grids[0].lattice;
  cv::Mat1b empty(l.active.size(), std::uint8_t{255});
  for (std::size_t i = 0; i < scene.samples.size(); ++i) {
    if (scene.lasers[i] == laser || scene.samples[i].weight <= 0.0F) continue;
    if (const auto node = NearestNode(scene.samples[i], l)) empty(*node) = 0;
  }
  return SquaredBorderDistance(empty, reach);
}

// The surface of all lasers but one, without the rim.
PlateLattice SolveOthers(const Scene& scene, int laser) {
  PlateLattice others = scene.grids[0].lattice;
  others.z = others.z.clone();
  std::vector<float> weights, heights;
  weights.reserve(scene.samples.size());
  heights.reserve(scene.samples.size());
  for (std::size_t i = 0; i < scene.samples.size(); ++i) {
    weights.push_back(scene.lasers[i] == laser ? 0.0F : scene.samples[i].weight);
    heights.push_back(scene.samples[i].z);
  }
  PlateStack stack = scene.stack;
  stack.SetSamples(weights, scene.grids);
  PlateSolver solver;
  stack.Solve(heights, weights, scene.grids[0], scene.plate, &solver, &others);
  return others;
}

std::vector<Residual> Compare(const Scene& scene, int laser) {
  const PlateLattice others = SolveOthers(scene, laser);
  PlateLattice surface = others;
  surface.z = cv::Mat1f();  // of its own
  cv::add(others.z, scene.rim, surface.z);
  const double h = 0.5 * others.step_px, step_mm = others.step_px * scene.options.mm_per_px;
  const double max_apart_mm = scene.options.max_apart_mm;
  const int reach = std::min(kMaxBorderReach, static_cast<int>(max_apart_mm / step_mm) + 2);
  const cv::Mat1w apart = SquaredDistanceToOthers(scene, laser, reach);
  std::vector<Residual> out;
  for (std::size_t i = 0; i < scene.samples.size(); ++i) {
    const PlateSample& s = scene.samples[i];
    const LatticePlace& place = scene.grids[0].places[i];
    if (scene.lasers[i] != laser || s.weight <= 0.0F || !place.known()) continue;
    const auto node = NearestNode(s, others);
    const double distance =
        node ? std::sqrt(static_cast<double>(apart(*node))) * step_mm : max_apart_mm + 1.0;
    if (distance > max_apart_mm) continue;
    const double du = (HeightAt(surface, s.u + h, s.v) - HeightAt(surface, s.u - h, s.v)) / (2.0 * h);
    const double dv = (HeightAt(surface, s.u, s.v + h) - HeightAt(surface, s.u, s.v - h)) / (2.0 * h);
    if (!std::isfinite(du) || !std::isfinite(dv)) continue;
    const RayField::Slope ray = scene.rays.SlopeAt(s.u, s.v);
    const double rise = HeightAt(surface, place) - scene.rays.center().z();
    const Eigen::Vector3d along(ray.m.x(), ray.m.y(), 1.0);
    Eigen::Vector3d along_u = du * along, along_v = dv * along;
    along_u.head<2>() += rise * ray.du;
    along_v.head<2>() += rise * ray.dv;
    Eigen::Vector3d normal = along_u.cross(along_v).normalized();
    if (normal.z() < 0.0) normal = -normal;
    const double tilt = normal.dot(along);
    out.push_back({normal, (s.z - HeightAt(others, place)) * tilt,
                   std::abs(tilt) / std::sqrt(static_cast<double>(s.weight)),
                   std::min(kBins - 1, static_cast<int>(distance / max_apart_mm * kBins)),
                   scene.patches.At(s)});
  }
  return out;
}

// What interpolation alone does to a residual, by distance: the spread beyond the samples' own sigma, as the
// median over the lasers has it.
std::array<double, kBins> InterpolationSpread(const std::vector<std::vector<Residual>>& all) {
  constexpr double kToSigma = 1.4826, kLeast = 0.01;
  std::array<double, kBins> out{};
  for (int bin = 0; bin < kBins; ++bin) {
    std::vector<double> by_laser;
    for (const auto& residuals : all) {
      std::vector<double> e, s2;
      for (const Residual& r : residuals) {
        if (r.bin != bin) continue;
        e.push_back(r.e);
        s2.push_back(r.sigma * r.sigma);
      }
      if (e.size() < 30) continue;
      const double middle = Median(e);
      for (double& x : e) x = std::abs(x - middle);
      const double spread = kToSigma * Median(e);
      by_laser.push_back(std::sqrt(std::max(kLeast * kLeast, spread * spread - Median(s2))));
    }
    out[static_cast<std::size_t>(bin)] = by_laser.empty() ? -1.0 : Median(by_laser);
  }
  double last = 0.3;  // mm, where no laser says anything
  for (double& s : out) last = s = s < 0.0 ? last : s;
  return out;
}

// Weighted least squares of e = a . t with Cauchy's weights; the covariance from the scatter between patches.
template <int N, class Row>
void FitShift(const std::vector<Residual>& residuals, const std::vector<double>& spreads,
              std::size_t patch_count, const Row& row, double prior, Eigen::Matrix<double, N, 1>* t,
              Eigen::Matrix<double, N, N>* covariance) {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  constexpr int kRounds = 8;
  constexpr double kCauchy = 2.4;
  t->setZero();
  const Matrix known = Matrix::Identity() / (prior * prior);
  Matrix normal = known;
  std::vector<Vector> patches(patch_count, Vector::Zero());
  for (int round = 0; round < kRounds; ++round) {
    normal = known;
    Vector right = Vector::Zero();
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const Vector a = row(residuals[i]);
      const double e = residuals[i].e - a.dot(*t), q = e / (kCauchy * spreads[i]);
      const double w = 1.0 / (spreads[i] * spreads[i] * (1.0 + q * q));
      normal += w * a * a.transpose();
      right += w * residuals[i].e * a;
      if (round + 1 == kRounds) patches[residuals[i].patch] += w * e * a;
    }
    *t = normal.ldlt().solve(right);
  }
  Matrix scatter = known;
  for (const Vector& g : patches) scatter += g * g.transpose();
  const Matrix inverse = normal.inverse();
  *covariance = kResidualsToErrors * kResidualsToErrors * inverse * scatter * inverse;
}

cv::Mat1f RimAtNodes(const Rim& rim, const PlateLattice& l) {
  cv::Mat1f out(l.active.size(), 0.0F);
  for (int r = 0; r < out.rows; ++r) {
    for (int c = 0; c < out.cols; ++c) {
      if (l.active(r, c) != 0) out(r, c) = rim.Height(l.U(c), l.V(r));
    }
  }
  return out;
}

}  // namespace

std::vector<LaserConsistency> CompareLasers(const std::vector<PlateSample>& samples,
                                            const std::vector<std::uint8_t>& lasers,
                                            std::span<const PlateGrid> fused, const PlateOptions& plate,
                                            const Rim& rim, const RayField& rays,
                                            const LaserConsistencyOptions& options, const Context& context) {
  std::vector<bool> present(256, false);
  for (const std::uint8_t laser : lasers) present[laser] = true;
  std::vector<LaserConsistency> out;
  for (int laser = 0; laser < 256; ++laser) {
    if (present[static_cast<std::size_t>(laser)]) out.push_back({.laser = laser});
  }
  if (out.size() < 2) return out;
  const Scene scene{.samples = samples,
                    .lasers = lasers,
                    .grids = fused,
                    .stack = PlateStack(plate, fused, context),
                    .plate = plate,
                    .rim = RimAtNodes(rim, fused[0].lattice),
                    .rays = rays,
                    .patches = Patches(samples, options.patch_mm / options.mm_per_px),
                    .options = options};
  std::vector<std::vector<Residual>> all(out.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(out.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    all[k] = Compare(scene, out[k].laser);
  });
  const std::array<double, kBins> interpolation = InterpolationSpread(all);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const std::vector<Residual>& residuals = all[k];
    if (residuals.size() < static_cast<std::size_t>(options.min_samples)) continue;
    LaserConsistency& one = out[k];
    one.samples = static_cast<int>(residuals.size());
    std::vector<double> spreads, ratios;
    for (const Residual& r : residuals) {
      spreads.push_back(std::hypot(r.sigma, interpolation[static_cast<std::size_t>(r.bin)]));
      ratios.push_back(std::abs(r.e) / spreads.back());
    }
    constexpr double kMedianOfNormal = 0.6745;
    one.chi2 = std::pow(Median(ratios) / kMedianOfNormal, 2);
    Eigen::Matrix<double, 1, 1> height, height_variance;
    FitShift<1>(
        residuals, spreads, scene.patches.size(),
        [](const Residual& r) { return Eigen::Matrix<double, 1, 1>(r.normal.z()); }, options.prior_shift_mm,
        &height, &height_variance);
    one.offset_mm = height[0];
    one.offset_sd_mm = std::sqrt(height_variance(0, 0));
    Eigen::Matrix3d covariance;
    FitShift<3>(
        residuals, spreads, scene.patches.size(), [](const Residual& r) { return r.normal; },
        options.prior_shift_mm, &one.shift_mm, &covariance);
    one.shift_sd_mm = covariance.diagonal().cwiseSqrt();
    one.shift_significance = std::sqrt(one.shift_mm.dot(covariance.ldlt().solve(one.shift_mm)));
  }
  return out;
}

}  // namespace dorsum
