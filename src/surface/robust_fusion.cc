// SPDX-License-Identifier: Apache-2.0
#include "surface/robust_fusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "base/median.h"
#include "base/parallel.h"
#include "surface/gathered_rows.h"
#include "surface/lattice_mesh.h"
#include "surface/mesh_raster.h"
#include "surface/outline.h"
#include "surface/plate.h"
#include "surface/plate_stack.h"
#include "surface/plate_stiffness.h"
#include "surface/plate_support.h"
#include "surface/ray_field.h"
#include "surface/rim.h"
#include "surface/sample_weights.h"
#include "surface/stripe_agreement.h"

namespace dorsum {
namespace {

constexpr float kLeastSigma = 0.01F;       // mm; no point is better than that
constexpr float kStartStiffness = 100.0F;  // of the coarsest lattice, before curvatures are known
constexpr double kCoarsestStepMm = 2.0;
// Each level starts from the one before, so these bring it within a micrometre of the solution.
constexpr int kIterations = 5, kExactIterations = 10;

// How many mm of the object one pixel spans, at the points' median depth.
double MmPerPixel(const SurfacePoints& points, const Camera& camera) {
  std::vector<double> depths;
  depths.reserve(points.size());
  for (const SurfacePoint& p : points) depths.push_back((camera.camera_from_world * p.position).z());
  return Median(std::move(depths)) / std::sqrt(camera.fx * camera.fy);
}

PlateLattice CopyOf(const PlateLattice& l) {
  PlateLattice out = l;
  out.z = l.z.clone();
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
        step_px_(options.pitches_per_node * options.pitch_mm / mm_per_px_),
        outline_(mask, static_cast<int>(std::ceil(2.0 * step_px_)) + 1,
                 static_cast<int>(std::ceil(RimOptions().reach_mm / mm_per_px_)) + 2, context),
        rays_(camera, outline_.bounds()) {
    plate_.mm_per_px = mm_per_px_;
    plate_.max_iterations = kIterations;
    out_.field.pitch_mm = options.pitch_mm;
    out_.verdicts.assign(points.size(), PointVerdict::kGood);
  }

  RobustFusion Run() {
    MakeSamples();
    MakeGrids();
    SolveCoarsest();
    const Rim rim = TakeRimOff();
    const std::size_t compared = coarsest_ > 0 ? 1 : 0;
    for (std::size_t i = coarsest_ + 1; i-- > compared;) SolveLevel(i);
    LevelLasers(&grids_[compared]);
    // What remains of the surface and the comparison of the lasers do not need each other.
    const PlateLattice level = CopyOf(grids_[compared].lattice);
    ParallelFor(context_, 0, 2, [&](std::int64_t part) {
      if (part == 1) return CompareLasers(rim, level);
      for (std::size_t i = compared; i-- > 0;) SolveLevel(i);
      Judge(rim);
      MakeSurface(rim);
    });
    out_.field.left_out = out_.misplaced + out_.outliers;
    return std::move(out_);
  }

 private:
  void MakeSamples() {
    const std::vector<bool> misplaced = FindMisplaced(points_, outline_, {.mm_per_px = mm_per_px_}, context_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (misplaced[i]) out_.verdicts[i] = PointVerdict::kMisplaced;
      out_.misplaced += misplaced[i] ? 1 : 0;
    }
    const int rows_of_step = std::max(1, static_cast<int>(step_px_));
    GatheredRows gathered = GatherRows(points_, misplaced, rows_of_step, kLeastSigma);
    samples_ = std::move(gathered.samples);
    lasers_ = std::move(gathered.lasers);
    pooled_ = std::move(gathered.pooled);
  }

  // From fine to coarse. Those beyond the coarsest to be solved help to solve it.
  void MakeGrids() {
    grids_ = dorsum::MakeGrids(MakeSupport(samples_, outline_,
                                           {.step_px = step_px_,
                                            .mm_per_px = mm_per_px_,
                                            .max_beyond_mm = options_.max_beyond_mm,
                                            .max_gap_mm = options_.max_gap_mm},
                                           context_),
                               mm_per_px_, samples_, context_);
    while (grids_[coarsest_].lattice.step_px * mm_per_px_ < kCoarsestStepMm) ++coarsest_;
  }

  // From the next coarser one, which tells how stiff the surface is.
  void SolveLevel(std::size_t i) {
    PlateLattice& l = grids_[i].lattice;
    if (i < coarsest_) {
      l.stiffness = LocalStiffness(grids_[i + 1].lattice, l, {.mm_per_px = mm_per_px_});
      Prolong(grids_[i + 1].lattice, &l);
    }
    Solve(i, {std::max(1.0, 0.6 * l.step_px * mm_per_px_)});
  }

  void MakeSurface(const Rim& rim) {
    PlateLattice& finest = grids_[0].lattice;
    ParallelFor(context_, 0, finest.z.rows, [&](std::int64_t row) {
      const int r = static_cast<int>(row);
      for (int c = 0; c < finest.z.cols; ++c) {
        if (finest.active(r, c) != 0) finest.z(r, c) += rim.Height(finest.U(c), finest.V(r));
      }
    });
    out_.mesh = MeshLattice(finest, outline_, rays_, options_.max_slope_deg, context_);
    out_.field = RasterizeMesh(out_.mesh, options_.pitch_mm, context_);
  }

  void Solve(std::size_t level, std::initializer_list<double> scales_mm) {
    PlateGrid& grid = grids_[level];
    const auto grids = std::span<const PlateGrid>(grids_).subspan(level);
    PlateStack stack(plate_, grids, context_);
    bool first = true;
    for (const double scale : scales_mm) {
      const std::vector<float> weights = Reweigh(samples_, grid, scale, options_.robust_sigmas, context_);
      first ? stack.SetSamples(weights, grids, context_) : stack.UpdateSamples(weights, grid);
      first = false;
      stack.Solve(Heights(samples_), weights, grid, plate_, &solver_, &grid.lattice);
    }
  }

  // From loose to tight, so that what few samples say does not bend the surface (graduated non-convexity).
  void SolveCoarsest() {
    PlateLattice& l = grids_[coarsest_].lattice;
    l.stiffness = cv::Mat3f(l.z.size(), cv::Vec3f::all(kStartStiffness));
    StartFromMedians(samples_, context_, &l);
    Solve(coarsest_, {8.0, 4.0, 2.5});
  }

  Rim TakeRimOff() {
    std::vector<PlateSample> weighed = samples_;
    SetWeights(Reweigh(samples_, grids_[coarsest_], 2.5, 2.0 * options_.robust_sigmas, context_), &weighed);
    Rim rim(weighed, outline_, {.mm_per_px = mm_per_px_}, context_);
    ParallelFor(context_, 0, static_cast<std::int64_t>(samples_.size()), [&](std::int64_t i) {
      PlateSample& s = samples_[static_cast<std::size_t>(i)];
      s.z -= rim.Height(s.u, s.v);
    });
    PlateLattice& l = grids_[coarsest_].lattice;
    for (int r = 0; r < l.z.rows; ++r) {
      for (int c = 0; c < l.z.cols; ++c) l.z(r, c) -= rim.Height(l.U(c), l.V(r));
    }
    return rim;
  }

  // An offset that is surely there is taken off; a large one is a movement, which no offset mends.
  void LevelLasers(PlateGrid* level) {
    PlateOptions exact = plate_;
    exact.max_iterations = kExactIterations;
    exact.tolerance = 1e-5;
    level->lattice.stiffness = LocalStiffness(level->lattice, level->lattice, {.mm_per_px = mm_per_px_});
    const auto grids =
        std::span<const PlateGrid>(grids_).subspan(static_cast<std::size_t>(level - grids_.data()));
    const std::vector<float> weights = Reweigh(samples_, *level, 1.0, 2.0 * options_.robust_sigmas, context_);
    PlateStack stack(plate_, grids, context_);
    stack.SetSamples(weights, grids, context_);
    PlateOptions rough = plate_;  // shares of the lasers need no more
    rough.max_iterations = exact.max_iterations;
    rough.tolerance = 1e-2;
    std::vector<PlateSample> weighed = samples_;
    SetWeights(weights, &weighed);
    std::vector<PlateLattice> indicators;
    const PlateGrid unsolved = *level;
    ParallelFor(context_, 0, 2, [&](std::int64_t part) {
      if (part == 0) {
        stack.Solve(Heights(samples_), weights, *level, exact, &solver_, &level->lattice);
      } else {
        indicators = SolveIndicators(weighed, lasers_, stack, unsolved, rough, context_);
      }
    });
    out_.offsets = EstimateLaserOffsets(weighed, lasers_, indicators, *level, {.mm_per_px = mm_per_px_});
    for (const LaserOffset& one : out_.offsets) {
      if (std::abs(one.mean_mm) > options_.max_offset_mm) return;
      if (std::abs(one.mean_mm) > options_.offset_sigmas * one.sd_mm) {
        off_mm_[static_cast<std::size_t>(one.laser)] = static_cast<float>(one.mean_mm);
      }
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].z -= off_mm_[lasers_[i]];
  }

  // The pooled heights, whose deviations tell a laser's shift from noise.
  std::vector<PlateSample> PooledSamples() const {
    std::vector<PlateSample> pooled = samples_;
    for (std::size_t i = 0; i < pooled.size(); ++i) {
      pooled[i].z += pooled_[i].change_mm;
      pooled[i].weight = pooled_[i].weight;
    }
    return pooled;
  }

  // A moved laser must not bend the surface of the others to itself, so the plate is stiffer here, and alike
  // in all directions.
  void CompareLasers(const Rim& rim, PlateLattice level) {
    level.stiffness = LocalStiffness(
        level, level,
        {.mm_per_px = mm_per_px_, .window_mm = 3.0, .correlation_area_mm2 = 1.0, .share_between = 1.0});
    std::vector<PlateSample> pooled = PooledSamples();
    std::vector<PlateGrid> grids(grids_.begin() + (coarsest_ > 0 ? 1 : 0), grids_.end());
    grids[0].lattice = level;
    SetWeights(
        Reweigh(pooled, grids[0], 0.6 * level.step_px * mm_per_px_, 2.0 * options_.robust_sigmas, context_),
        &pooled);
    out_.lasers = dorsum::CompareLasers(pooled, lasers_, grids, plate_, rim, rays_, {.mm_per_px = mm_per_px_},
                                        context_);
  }

  void Judge(const Rim& rim) {
    ParallelFor(context_, 0, static_cast<std::int64_t>(points_.size()), [&](std::int64_t at) {
      const auto i = static_cast<std::size_t>(at);
      if (out_.verdicts[i] != PointVerdict::kGood) return;
      const SurfacePoint& p = points_[i];
      const float z = HeightAt(grids_[0].lattice, p.u, p.v) + rim.Height(p.u, p.v) + off_mm_[p.laser];
      const double limit =
          std::max(options_.outlier_mm, options_.outlier_sigmas * static_cast<double>(p.sigma));
      if (!std::isfinite(z)) {
        out_.verdicts[i] = PointVerdict::kUnused;
      } else if (std::abs(p.position.z() - static_cast<double>(z)) > limit) {
        out_.verdicts[i] = PointVerdict::kOutlier;
      }
    });
    out_.outliers =
        static_cast<int>(std::count(out_.verdicts.begin(), out_.verdicts.end(), PointVerdict::kOutlier));
  }

  const SurfacePoints& points_;
  const RobustFusionOptions& options_;
  const Context& context_;
  double mm_per_px_, step_px_;  // of the finest lattice
  Outline outline_;
  RayField rays_;
  PlateOptions plate_;
  std::vector<PlateSample> samples_;  // heights without the rim and the lasers' offsets
  std::vector<PooledHeight> pooled_;  // of the samples
  std::vector<std::uint8_t> lasers_;
  std::array<float, 256> off_mm_{};  // what was taken off each laser's heights
  std::vector<PlateGrid> grids_;
  std::size_t coarsest_ = 0;  // of the grids, the first to be solved
  PlateSolver solver_;
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
