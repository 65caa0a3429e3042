// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/median.h"
#include "base/parallel.h"
#include "calibration/bundle_boards.h"
#include "calibration/bundle_residuals.h"
#include "calibration/bundle_verdicts.h"
#include "calibration/bundle_world.h"
#include "calibration/central_places.h"

namespace dorsum {
namespace {

// One calibration on its way.
class Bundler {
 public:
  Bundler(const CalibrationSeries& series, const BundleOptions& options, const Context& context)
      : series_(series), options_(options), problem_(options.problem), context_(context) {}

  Result<BundleCalibration> Run(const CameraCalibrationOptions& camera) {
    // What is seen of the stripes and the drawn lines does not wait for camera and boards.
    std::array<Status, 3> status;
    Context inner = context_;
    if (context_.sink != nullptr) inner.threads = 1;  // a sink is called from one thread
    ParallelFor(inner, 0, 3, [&](std::int64_t task) {
      status[static_cast<std::size_t>(task)] = task == 0   ? FindStripes()
                                               : task == 1 ? FindLines()
                                                           : StartWithBoards(camera);
    });
    for (const Status& s : {status[2], status[0], status[1]}) DORSUM_RETURN_IF_ERROR(s);
    DORSUM_RETURN_IF_ERROR(StartSheets());
    DORSUM_RETURN_IF_ERROR(SolveSheets());
    DORSUM_RETURN_IF_ERROR(CheckAndRepeat());
    Finish();
    return std::move(out_);
  }

 private:
  Status FindStripes() {
    SheetPictureOptions pictures = options_.pictures;
    pictures.pooling.every_rows = options_.assignment.every_rows;
    pictures.pooling.first_row = options_.assignment.end_rows;
    DORSUM_ASSIGN_OR_RETURN(pictures_, FindSheetPictures(series_, pictures, context_));
    for (const SheetPicture& p : pictures_) {
      out_.pictures.push_back(p.name);
      out_.laser_of_picture.push_back(p.laser);
    }
    return {};
  }

  // Without them, the brightest stripes are the central ones.
  Status FindLines() {
    Result<DrawnLines> drawn = FindDrawnLines(series_, options_.first_estimates, context_);
    if (drawn.ok()) out_.drawn = std::move(*drawn);
    return {};
  }

  Status StartWithBoards(const CameraCalibrationOptions& camera) {
    DORSUM_ASSIGN_OR_RETURN(out_.start, CalibrateCamera(series_, camera, context_));
    DORSUM_RETURN_IF_ERROR(CollectBoards(series_, out_.start, context_, &out_.data, &out_.warnings));
    out_.data.planes = PlanesOfSeries(series_);
    return SolveBoards(out_.start.camera);
  }

  // Camera and boards alone, which says how well corners are found, whether the board is flat, and how high
  // the calibration object really is.
  Status SolveBoards(const Camera& camera) {
    BundleProblemOptions boards = problem_;
    boards.use_points = false;
    DORSUM_ASSIGN_OR_RETURN(solution_,
                            SolveBundle(out_.data, StartOfBoards(camera, out_.data), boards, context_));
    const double usual = Median(ViewErrors(out_.data, solution_.state));
    problem_.corner_sd_px = std::clamp(usual / std::sqrt(2.0), 0.03, 1.0);
    boards.corner_sd_px = problem_.corner_sd_px;
    DORSUM_ASSIGN_OR_RETURN(out_.board, CheckBoard(out_.data, solution_.state, boards, context_));
    problem_.bow_boards = boards.bow_boards = BoardIsBent(out_.board, options_.verdicts);
    if (problem_.bow_boards) solution_.state.board_bow = out_.board.bow;
    DORSUM_ASSIGN_OR_RETURN(solution_, SolveBundle(out_.data, solution_.state, boards, context_));
    DORSUM_ASSIGN_OR_RETURN(out_.heights, CheckHeights(out_.data, solution_.state, boards, context_));
    FreeWrongHeights();
    return {};
  }

  // A height that everything else contradicts is found instead of believed.
  bool FreeWrongHeights() {
    bool any = false;
    for (const HeightCheck& h : out_.heights) {
      HeightPlane& plane = out_.data.planes[static_cast<std::size_t>(h.plane)];
      if (!HeightIsWrong(h, options_.verdicts) || plane.sd_mm >= kUnknownHeightSd) continue;
      plane.sd_mm = kUnknownHeightSd;
      solution_.state.planes[static_cast<std::size_t>(h.plane)][0] = h.fitted_mm;
      any = true;
    }
    return any;
  }

  Status StartSheets() {
    const Camera camera = solution_.state.GetCamera();
    const std::map<int, double> central =
        CentralPlaces(series_, camera, pictures_, out_.drawn, options_, &out_.warnings);
    std::vector<std::optional<Result<SheetStart>>> starts(series_.lasers.size());
    ParallelFor(context_, 0, static_cast<std::int64_t>(starts.size()), [&](std::int64_t i) {
      const int index = static_cast<int>(i);
      const auto place = central.find(series_.lasers[static_cast<std::size_t>(i)]);
      starts[static_cast<std::size_t>(i)] = EstimateSheets(
          camera, FindPicture(pictures_, index, "backplane")->stripes,
          FindPicture(pictures_, index, "Closer")->stripes, solution_.state.planes[1][0],
          place == central.end() ? std::nullopt : std::optional(place->second), options_.start);
    });
    for (const auto& start : starts) {
      if (!start->ok()) return start->error();
      solution_.state.fans.push_back(FanFromGeometry((*start)->fan));
    }
    return {};
  }

  // Each round predicts better, so that it may believe less; the last one moves everything.
  Status SolveSheets() {
    constexpr double kTolerances[] = {0.25, 0.12};
    for (std::size_t round = 0; round < std::size(kTolerances); ++round) {
      context_.Report("bundle: light sheets", 0.4 + 0.1 * static_cast<double>(round));
      BundleProblemOptions problem = problem_;
      problem.move_camera = false;
      Assign(kTolerances[round], 2);
      DORSUM_ASSIGN_OR_RETURN(solution_, SolveBundle(out_.data, solution_.state, problem, context_));
    }
    return SolveAll();
  }

  void Assign(double tolerance, int thin) {
    SheetAssignmentOptions assignment = options_.assignment;
    assignment.tolerance = tolerance;
    assignment.every_rows *= thin;
    out_.data.points = AssignOrders(pictures_, solution_.state, assignment, context_);
    out_.assigned = AssignedShares(pictures_, out_.data.points, assignment);
    for (const SeriesCheck& s : out_.left_out) {
      std::erase_if(out_.data.points, [&s](const SheetPoint& p) { return p.source == s.source; });
    }
  }

  Status SolveAll() {
    context_.Report("bundle: everything", 0.6);
    TurnWorldToCentral();
    constexpr double kTolerance = 0.06;
    Assign(kTolerance, 1);
    BundleProblemOptions problem = problem_;
    problem.uncertainties = true;
    DORSUM_ASSIGN_OR_RETURN(solution_, SolveBundle(out_.data, solution_.state, problem, context_));
    TurnWorldToCentral();
    return {};
  }

  void TurnWorldToCentral() {
    const auto one = std::find(series_.lasers.begin(), series_.lasers.end(), 1);
    const auto reference =
        static_cast<std::size_t>(one == series_.lasers.end() ? 0 : one - series_.lasers.begin());
    dorsum::TurnWorldToCentral(reference, &solution_.state);
  }

  // What contradicts the rest is set free or left out, and everything solved once more without it.
  Status CheckAndRepeat() {
    context_.Report("bundle: checks", 0.75);
    DORSUM_ASSIGN_OR_RETURN(out_.heights, CheckHeights(out_.data, solution_.state, problem_, context_));
    bool again = FreeWrongHeights();
    DORSUM_ASSIGN_OR_RETURN(out_.series, CheckSeries(out_.data, solution_.state, problem_, context_));
    for (std::size_t k = 0; k < series_.lasers.size() && !again; ++k) {
      const SeriesCheck* worst = nullptr;
      for (const SeriesCheck& s : out_.series) {
        if (s.laser != static_cast<int>(k) || s.off_mm <= options_.verdicts.moved_mm) continue;
        if (worst == nullptr || s.rest_sd < worst->rest_sd) worst = &s;
      }
      if (worst != nullptr) out_.left_out.push_back(*worst);
    }
    again = again || !out_.left_out.empty();
    return again ? SolveAll() : Status();
  }

  void Finish() {
    out_.solution = std::move(solution_);
    const BundleState& state = out_.solution.state;
    out_.device.camera = state.GetCamera();
    for (std::size_t i = 0; i < series_.lasers.size(); ++i) {
      LaserGeometry laser;
      laser.laser = series_.lasers[i];
      laser.fan = GeometryFromFan(state.fans[i]);
      laser.grating = laser.fan->origin;
      out_.device.lasers.push_back(laser);
    }
    out_.residuals = Residuals(out_);
    for (std::size_t i = 0; i < out_.device.lasers.size(); ++i) FinishLaser(i);
    out_.view_rms_px = ViewErrors(out_.data, state);
    out_.parts = JudgeBundle(out_, options_.verdicts);
  }

  void FinishLaser(std::size_t i) {
    LaserGeometry& laser = out_.device.lasers[i];
    laser.min_order = 1000;
    laser.max_order = -1000;
    std::vector<PatternPoint> pattern;
    double mm_of_height = 0.0, count = 0.0;
    for (const SheetResidual& r : out_.residuals) {
      if (r.laser != laser.laser) continue;
      pattern.push_back({r.order, r.y_mm, r.height_mm, r.miss_mm});
      mm_of_height += r.height_per_mm;
      count += 1.0;
      if (r.height_mm != 0.0) continue;
      laser.min_order = std::min(laser.min_order, r.order);
      laser.max_order = std::max(laser.max_order, r.order);
    }
    if (laser.min_order > laser.max_order) laser.min_order = laser.max_order = 0;
    out_.pattern_mm.push_back(LeftPattern(pattern));
    const double by_parameters =
        HeightUncertainty(out_.solution.state, out_.solution.covariance, static_cast<int>(i), laser.min_order,
                          laser.max_order, out_.device.min_height_mm, out_.device.max_height_mm);
    const double by_pattern = count > 0.0 ? out_.pattern_mm.back() * mm_of_height / count : 0.0;
    laser.residual_mm = std::hypot(by_parameters, by_pattern);
  }

  const CalibrationSeries& series_;
  const BundleOptions& options_;
  BundleProblemOptions problem_;
  const Context& context_;
  std::vector<SheetPicture> pictures_;
  BundleSolution solution_;
  BundleCalibration out_;
};

}  // namespace

Result<BundleCalibration> CalibrateBundle(const CalibrationSeries& series,
                                          const CameraCalibrationOptions& camera,
                                          const BundleOptions& options, const Context& context) {
  context.Report("chessboards and stripes", 0.0);
  return Bundler(series, options, context).Run(camera);
}

}  // namespace dorsum
