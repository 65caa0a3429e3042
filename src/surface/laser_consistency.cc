// SPDX-License-Identifier: Apache-2.0
#include "surface/laser_consistency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "base/parallel.h"

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
  std::pair<int, int> patch;
};

// Distance in lattice steps to the nearest sample of any other laser.
cv::Mat1f DistanceToOthers(const std::vector<PlateSample>& samples, const std::vector<std::uint8_t>& lasers,
                           int laser, const PlateLattice& l) {
  cv::Mat1b empty(l.active.size(), std::uint8_t{255});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlateSample& s = samples[i];
    if (lasers[i] == laser || s.weight <= 0.0F) continue;
    const long c = std::lround((s.u - l.u0) / l.step_px), r = std::lround((s.v - l.v0) / l.step_px);
    if (c >= 0 && r >= 0 && c < empty.cols && r < empty.rows)
      empty(static_cast<int>(r), static_cast<int>(c)) = 0;
  }
  cv::Mat1f out;
  cv::distanceTransform(empty, out, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return out;
}

std::vector<Residual> Compare(const std::vector<PlateSample>& samples,
                              const std::vector<std::uint8_t>& lasers, int laser, const PlateLattice& fused,
                              const PlateOptions& plate, const Rim& rim, const RayField& rays,
                              const LaserConsistencyOptions& options) {
  PlateLattice others = fused;
  others.z = fused.z.clone();
  std::vector<PlateSample> kept = samples;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (lasers[i] == laser) kept[i].weight = 0.0F;
  }
  SolvePlate(kept, plate, &others);
  const cv::Mat1f apart = DistanceToOthers(samples, lasers, laser, fused);
  const double h = 0.5 * fused.step_px, step_mm = fused.step_px * options.mm_per_px;
  const auto surface = [&](double u, double v) {
    return rays.At(u, v, HeightAt(others, u, v) + rim.Height(u, v));
  };
  std::vector<Residual> out;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlateSample& s = samples[i];
    if (lasers[i] != laser || s.weight <= 0.0F) continue;
    const long c = std::lround((s.u - fused.u0) / fused.step_px),
               r = std::lround((s.v - fused.v0) / fused.step_px);
    if (c < 0 || r < 0 || c >= apart.cols || r >= apart.rows) continue;
    const double distance = apart(static_cast<int>(r), static_cast<int>(c)) * step_mm;
    if (distance > options.max_apart_mm) continue;
    const Eigen::Vector3d du = surface(s.u + h, s.v) - surface(s.u - h, s.v);
    const Eigen::Vector3d dv = surface(s.u, s.v + h) - surface(s.u, s.v - h);
    const double z = HeightAt(others, s.u, s.v);
    Eigen::Vector3d normal = du.cross(dv).normalized();
    if (!normal.allFinite() || !std::isfinite(z)) continue;
    if (normal.z() < 0.0) normal = -normal;
    const Eigen::Vector3d along = rays.At(s.u, s.v, s.z + 1.0) - rays.At(s.u, s.v, s.z);
    const double tilt = normal.dot(along);
    const int bin = std::min(kBins - 1, static_cast<int>(distance / options.max_apart_mm * kBins));
    out.push_back({normal,
                   (s.z - z) * tilt,
                   std::abs(tilt) / std::sqrt(static_cast<double>(s.weight)),
                   bin,
                   {static_cast<int>(std::floor(s.u * options.mm_per_px / options.patch_mm)),
                    static_cast<int>(std::floor(s.v * options.mm_per_px / options.patch_mm))}});
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
void FitShift(const std::vector<Residual>& residuals, const std::vector<double>& spreads, const Row& row,
              double prior, Eigen::Matrix<double, N, 1>* t, Eigen::Matrix<double, N, N>* covariance) {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  constexpr int kRounds = 8;
  constexpr double kCauchy = 2.4;
  t->setZero();
  const Matrix known = Matrix::Identity() / (prior * prior);
  Matrix normal = known;
  std::map<std::pair<int, int>, Vector> patches;
  for (int round = 0; round < kRounds; ++round) {
    normal = known;
    Vector right = Vector::Zero();
    patches.clear();
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const Vector a = row(residuals[i]);
      const double e = residuals[i].e - a.dot(*t), q = e / (kCauchy * spreads[i]);
      const double w = 1.0 / (spreads[i] * spreads[i] * (1.0 + q * q));
      normal += w * a * a.transpose();
      right += w * residuals[i].e * a;
      patches.try_emplace(residuals[i].patch, Vector::Zero()).first->second += w * e * a;
    }
    *t = normal.ldlt().solve(right);
  }
  Matrix scatter = known;
  for (const auto& [patch, g] : patches) scatter += g * g.transpose();
  const Matrix inverse = normal.inverse();
  *covariance = kResidualsToErrors * kResidualsToErrors * inverse * scatter * inverse;
}

}  // namespace

std::vector<LaserConsistency> CompareLasers(const std::vector<PlateSample>& samples,
                                            const std::vector<std::uint8_t>& lasers,
                                            const PlateLattice& fused, const PlateOptions& plate,
                                            const Rim& rim, const RayField& rays,
                                            const LaserConsistencyOptions& options, const Context& context) {
  std::map<int, int> present;
  for (const std::uint8_t laser : lasers) ++present[laser];
  std::vector<LaserConsistency> out;
  out.reserve(present.size());
  for (const auto& [laser, count] : present) out.push_back({.laser = laser});
  if (out.size() < 2) return out;
  std::vector<std::vector<Residual>> all(out.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(out.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    all[k] = Compare(samples, lasers, out[k].laser, fused, plate, rim, rays, options);
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
        residuals, spreads, [](const Residual& r) { return Eigen::Matrix<double, 1, 1>(r.normal.z()); },
        options.prior_shift_mm, &height, &height_variance);
    one.offset_mm = height[0];
    one.offset_sd_mm = std::sqrt(height_variance(0, 0));
    Eigen::Matrix3d covariance;
    FitShift<3>(
        residuals, spreads, [](const Residual& r) { return r.normal; }, options.prior_shift_mm, &one.shift_mm,
        &covariance);
    one.shift_sd_mm = covariance.diagonal().cwiseSqrt();
    one.shift_significance = std::sqrt(one.shift_mm.dot(covariance.ldlt().solve(one.shift_mm)));
  }
  return out;
}

}  // namespace dorsum
