// SPDX-License-Identifier: Apache-2.0
#include "surface/robust_fusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/median.h"
#include "base/parallel.h"
#include "surface/lattice_mesh.h"
#include "surface/outline.h"
#include "surface/plate.h"
#include "surface/plate_stiffness.h"
#include "surface/plate_support.h"
#include "surface/ray_field.h"
#include "surface/rim.h"
#include "surface/stripe_agreement.h"

namespace dorsum {
namespace {

constexpr float kLeastSigma = 0.01F;       // mm; no point is better than that
constexpr float kStartStiffness = 100.0F;  // of the coarsest lattice, before curvatures are known
constexpr double kCoarsestStepMm = 2.0;
// Each level starts from the one before, so these bring it far below the points' noise.
constexpr int kIterations = 100, kExactIterations = 400;

// How many mm of the object one pixel spans, at the points' median depth.
double MmPerPixel(const SurfacePoints& points, const Camera& camera) {
  std::vector<double> depths;
  depths.reserve(points.size());
  for (const SurfacePoint& p : points) depths.push_back((camera.camera_from_world * p.position).z());
  return Median(std::move(depths)) / std::sqrt(camera.fx * camera.fy);
}

// Geman and McClure's weights for the residuals against the present surface.
std::vector<PlateSample> Reweigh(const std::vector<PlateSample>& samples, const PlateLattice& l,
                                 double scale_mm, double sigmas) {
  std::vector<PlateSample> out = samples;
  for (PlateSample& s : out) {
    const float z = HeightAt(l, s.u, s.v);
    if (s.weight <= 0.0F || !std::isfinite(z)) continue;
    const double scale = std::max(scale_mm, sigmas / std::sqrt(static_cast<double>(s.weight)));
    const double e = (s.z - z) / scale;
    s.weight = static_cast<float>(s.weight / ((1.0 + e * e) * (1.0 + e * e)));
  }
  return out;
}

class Fuser {
 public:
  Fuser(const SurfacePoints& points, const Camera& camera, const cv::Mat& mask,
        const RobustFusionOptions& options, const Context& context)
      : points_(points),
        options_(options),
        context_(context),
        mm_per_px_(MmPerPixel(points, camera)),
        outline_(mask, static_cast<int>(std::ceil(2.0 * options.pitch_mm / mm_per_px_)) + 1),
        rays_(camera, outline_.bounds()) {
    plate_.mm_per_px = mm_per_px_;
    plate_.max_iterations = kIterations;
    out_.field.pitch_mm = options.pitch_mm;
    out_.verdicts.assign(points.size(), PointVerdict::kGood);
  }

  RobustFusion Run() {
    MakeSamples();
    MakeLevels();
    SolveCoarsest();
    const Rim rim = TakeRimOff();
    const std::size_t compared = levels_.size() > 1 ? levels_.size() - 2 : 0;
    for (std::size_t i = 0; i <= compared; ++i) SolveLevel(i);
    LevelLasers(&levels_[compared]);
    // What remains of the surface and the comparison of the lasers do not need each other.
    const PlateLattice level = levels_[compared];
    ParallelFor(context_, 0, 2, [&](std::int64_t part) {
      if (part == 1) return CompareLasers(rim, level);
      for (std::size_t i = compared + 1; i < levels_.size(); ++i) SolveLevel(i);
      Judge();
      MakeSurface(rim);
    });
    out_.field.left_out = out_.misplaced + out_.outliers;
    return std::move(out_);
  }

 private:
  void MakeSamples() {
    samples_.reserve(points_.size());
    const std::vector<bool> misplaced = FindMisplaced(points_, outline_, {.mm_per_px = mm_per_px_});
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const SurfacePoint& p = points_[i];
      const bool pooled = p.row_sigma > 0.0F;  // the plate does that better, over the lasers too
      const float sigma = std::max(pooled ? p.row_sigma : p.sigma, kLeastSigma);
      const float weight = misplaced[i] ? 0.0F : 1.0F / (sigma * sigma);
      samples_.push_back({p.u, p.v, pooled ? p.row_z : static_cast<float>(p.position.z()), weight});
      lasers_.push_back(p.laser);
      if (misplaced[i]) out_.verdicts[i] = PointVerdict::kMisplaced;
      out_.misplaced += misplaced[i] ? 1 : 0;
    }
  }

  void MakeLevels() {
    levels_ = {MakeSupport(samples_, outline_,
                           {.step_px = options_.pitch_mm / mm_per_px_,
                            .mm_per_px = mm_per_px_,
                            .max_beyond_mm = options_.max_beyond_mm,
                            .max_gap_mm = options_.max_gap_mm})};
    while (levels_.back().step_px * mm_per_px_ < kCoarsestStepMm) levels_.push_back(Coarsen(levels_.back()));
    std::reverse(levels_.begin(), levels_.end());
  }

  // From the next coarser one, which tells how stiff the surface is.
  void SolveLevel(std::size_t i) {
    if (i > 0) {
      levels_[i].stiffness = LocalStiffness(levels_[i - 1], levels_[i], {.mm_per_px = mm_per_px_});
      Prolong(levels_[i - 1], &levels_[i]);
    }
    const double scale = std::max(1.0, 0.6 * levels_[i].step_px * mm_per_px_);
    Solve(i, {scale, scale});
  }

  void MakeSurface(const Rim& rim) {
    PlateLattice& finest = levels_.back();
    for (int r = 0; r < finest.z.rows; ++r) {
      for (int c = 0; c < finest.z.cols; ++c) {
        if (finest.active(r, c) != 0) finest.z(r, c) += rim.Height(finest.U(c), finest.V(r));
      }
    }
    out_.mesh = MeshLattice(finest, outline_, rays_, options_.max_slope_deg);
    out_.field = RasterizeMesh(out_.mesh, options_.pitch_mm);
  }

  void Solve(std::size_t level, std::initializer_list<double> scales_mm) {
    for (const double scale : scales_mm) {
      SolvePlate(Reweigh(samples_, levels_[level], scale, options_.robust_sigmas), plate_, &levels_[level]);
    }
  }

  // From loose to tight, so that what few samples say does not bend the surface (graduated non-convexity).
  void SolveCoarsest() {
    levels_[0].stiffness = cv::Mat3f(levels_[0].z.size(), cv::Vec3f::all(kStartStiffness));
    StartFromMedians(samples_, levels_.data());
    Solve(0, {8.0, 4.0, 2.5});
  }

  Rim TakeRimOff() {
    Rim rim(Reweigh(samples_, levels_[0], 2.5, 2.0 * options_.robust_sigmas), outline_,
            {.mm_per_px = mm_per_px_}, context_);
    for (PlateSample& s : samples_) s.z -= rim.Height(s.u, s.v);
    PlateLattice& l = levels_[0];
    for (int r = 0; r < l.z.rows; ++r) {
      for (int c = 0; c < l.z.cols; ++c) l.z(r, c) -= rim.Height(l.U(c), l.V(r));
    }
    return rim;
  }

  // An offset that is surely there is taken off; a large one is a movement, which no offset mends.
  void LevelLasers(PlateLattice* level) {
    PlateOptions exact = plate_;
    exact.max_iterations = kExactIterations;
    exact.tolerance = 1e-5;
    level->stiffness = LocalStiffness(*level, *level, {.mm_per_px = mm_per_px_});
    const std::vector<PlateSample> weighed = Reweigh(samples_, *level, 1.0, 2.0 * options_.robust_sigmas);
    SolvePlate(weighed, exact, level);
    PlateOptions rough = plate_;  // shares of the lasers need no more
    rough.tolerance = 1e-2;
    out_.offsets = EstimateLaserOffsets(weighed, lasers_, *level, rough, {.mm_per_px = mm_per_px_}, context_);
    std::array<float, 256> off{};
    for (const LaserOffset& one : out_.offsets) {
      if (std::abs(one.mean_mm) > options_.max_offset_mm) return;
      if (std::abs(one.mean_mm) > options_.offset_sigmas * one.sd_mm) {
        off[static_cast<std::size_t>(one.laser)] = static_cast<float>(one.mean_mm);
      }
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].z -= off[lasers_[i]];
  }

  // The pooled heights, whose deviations tell a laser's shift from noise.
  std::vector<PlateSample> PooledSamples() const {
    std::vector<PlateSample> pooled = samples_;
    for (std::size_t i = 0; i < pooled.size(); ++i) {
      const SurfacePoint& p = points_[i];
      if (pooled[i].weight <= 0.0F || p.row_sigma <= 0.0F) continue;
      const float sigma = std::max(p.sigma, kLeastSigma);
      pooled[i].z += static_cast<float>(p.position.z()) - p.row_z;
      pooled[i].weight = 1.0F / (sigma * sigma);
    }
    return pooled;
  }

  // A moved laser must not bend the surface of the others to itself, so the plate is stiffer here, and alike
  // in all directions.
  void CompareLasers(const Rim& rim, PlateLattice level) {
    level.stiffness = LocalStiffness(
        level, level,
        {.mm_per_px = mm_per_px_, .window_mm = 3.0, .correlation_area_mm2 = 1.0, .share_between = 1.0});
    const std::vector<PlateSample> weighed =
        Reweigh(PooledSamples(), level, 0.6 * level.step_px * mm_per_px_, 2.0 * options_.robust_sigmas);
    out_.lasers = dorsum::CompareLasers(weighed, lasers_, level, plate_, rim, rays_,
                                        {.mm_per_px = mm_per_px_}, context_);
  }

  void Judge() {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const PlateSample& s = samples_[i];
      if (s.weight <= 0.0F) continue;
      const float z = HeightAt(levels_.back(), s.u, s.v);
      const double limit =
          std::max(options_.outlier_mm, options_.outlier_sigmas * static_cast<double>(points_[i].sigma));
      const double own =
          points_[i].row_sigma > 0.0F ? points_[i].position.z() - static_cast<double>(points_[i].row_z) : 0.0;
      if (!std::isfinite(z)) {
        out_.verdicts[i] = PointVerdict::kUnused;
      } else if (std::abs(static_cast<double>(s.z - z) + own) > limit) {
        out_.verdicts[i] = PointVerdict::kOutlier;
        ++out_.outliers;
      }
    }
  }

  const SurfacePoints& points_;
  const RobustFusionOptions& options_;
  const Context& context_;
  double mm_per_px_;
  Outline outline_;
  RayField rays_;
  PlateOptions plate_;
  std::vector<PlateSample> samples_;  // heights without the rim and the lasers' offsets
  std::vector<std::uint8_t> lasers_;
  std::vector<PlateLattice> levels_;  // from coarse to fine
  RobustFusion out_;
};

}  // namespace

RobustFusion FuseRobust(const SurfacePoints& points, const Camera& camera, const cv::Mat& mask,
                        const RobustFusionOptions& options, const Context& context) {
  if (!points.empty()) return Fuser(points, camera, mask, options, context).Run();
  RobustFusion empty;
  empty.field.pitch_mm = options.pitch_mm;
  return empty;
}

}  // namespace dorsum
