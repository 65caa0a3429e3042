// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_calibration.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <opencv2/calib3d.hpp>

#include "base/parallel.h"
#include "calibration/bundle_functions.h"
#include "calibration/bundle_verdicts.h"
#include "calibration/chessboard.h"
#include "captures/image_file.h"
#include "captures/names.h"

namespace dorsum {
namespace {

// World pose of a board from its corners, by the camera as it is known so far.
Rigid3 PlaceBoard(const Camera& camera, const std::vector<Eigen::Vector3d>& board,
                  const std::vector<Eigen::Vector2d>& corners) {
  std::vector<cv::Point3d> object;
  std::vector<cv::Point2d> image;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    object.emplace_back(board[i].x(), board[i].y(), board[i].z());
    image.emplace_back(corners[i].x(), corners[i].y());
  }
  const cv::Matx33d matrix(camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0);
  const std::vector<double> distortion(camera.distortion.begin(), camera.distortion.end());
  cv::Mat rvec, tvec, rotation;
  cv::solvePnP(object, image, matrix, distortion, rvec, tvec);
  cv::Rodrigues(rvec, rotation);
  Rigid3 camera_from_board;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) camera_from_board.rotation(r, c) = rotation.at<double>(r, c);
    camera_from_board.translation[r] = tvec.at<double>(r);
  }
  return camera.camera_from_world.Inverse() * camera_from_board;
}

std::vector<Eigen::Vector2d> ToEigen(const std::vector<cv::Point2f>& corners) {
  std::vector<Eigen::Vector2d> out;
  out.reserve(corners.size());
  for (const cv::Point2f& c : corners) out.emplace_back(c.x, c.y);
  return out;
}

// The boards that lie where each laser was observed (§3.2).
Result<std::vector<BoardView>> FindLyingBoards(const CalibrationSeries& series, const Context& context) {
  std::vector<BoardView> views;
  for (const int k : series.lasers) {
    views.push_back({LaserChessName(k, Distance::kFurther), {}, 0});
    views.push_back({LaserChessName(k, Distance::kCloser), {}, 1});
  }
  const cv::Size inner(series.setup.board_columns, series.setup.board_rows);
  std::vector<Status> status(views.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(views.size()), [&](std::int64_t i) {
    BoardView& view = views[static_cast<std::size_t>(i)];
    if (context.IsCancelled()) return;
    const Result<cv::Mat> image = series.Read(view.name);
    if (!image.ok()) {
      status[static_cast<std::size_t>(i)] = image.error();
    } else if (const auto corners = FindChessboard(GreenChannel(*image), inner)) {
      view.corners = ToEigen(*corners);
    }
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  return views;
}

Status CollectBoards(const CalibrationSeries& series, const CameraCalibration& camera, const Context& context,
                     BundleCalibration* out) {
  const cv::Size inner(series.setup.board_columns, series.setup.board_rows);
  for (const cv::Point3f& p : ChessboardPoints(inner, series.setup.square_mm)) {
    out->data.board_points.emplace_back(p.x, -p.y, 0.0);  // the image's v runs against the world's y
  }
  for (std::size_t i = 0; i < camera.views.size(); ++i) {
    out->data.boards.push_back({camera.views[i], ToEigen(camera.corners[i]), i == 0 ? 0 : -1});
  }
  DORSUM_ASSIGN_OR_RETURN(const std::vector<BoardView> lying, FindLyingBoards(series, context));
  for (const BoardView& view : lying) {
    if (view.corners.empty()) {
      out->warnings.push_back("no chessboard of " + std::to_string(inner.width) + "x" +
                              std::to_string(inner.height) + " inner corners is seen whole in " + view.name +
                              "; going on without it");
    } else {
      out->data.boards.push_back(view);
    }
  }
  return {};
}

BundleState StartState(const Camera& camera, const BundleData& data) {
  BundleState state;
  state.width = camera.width;
  state.height = camera.height;
  state.lens = LensFromCamera(camera);
  state.camera_from_world = PoseFromRigid(camera.camera_from_world);
  for (std::size_t i = 0; i < data.boards.size(); ++i) {
    Rigid3 pose;  // the first board is the world
    if (i > 0) pose = PlaceBoard(camera, data.board_points, data.boards[i].corners);
    state.world_from_board.push_back(PoseFromRigid(pose));
  }
  for (const HeightPlane& plane : data.planes) state.planes.push_back({plane.given_mm, 0.0, 0.0});
  return state;
}

const SheetPicture* FindPicture(const std::vector<SheetPicture>& pictures, int laser,
                                const std::string& series) {
  for (const SheetPicture& p : pictures) {
    if (p.laser == laser && p.series == series) return &p;
  }
  return nullptr;
}

// Which drawn line (§3.2) belongs to which laser, by the lasers' brightest stripes.
std::map<int, double> CentralPlaces(const CalibrationSeries& series, const Camera& camera,
                                    const std::vector<SheetPicture>& pictures, const BundleOptions& options,
                                    const Context& context, std::vector<std::string>* warnings) {
  std::map<int, double> brightest;
  std::map<int, double> spacing;
  for (std::size_t i = 0; i < series.lasers.size(); ++i) {
    const SheetPicture* picture = FindPicture(pictures, static_cast<int>(i), "backplane");
    const std::vector<StripeLine> lines = LinesOnPlane(camera, picture->stripes, 0.0, options.start);
    if (lines.size() < 2) continue;
    const auto best = std::max_element(lines.begin(), lines.end(),
                                       [](const auto& a, const auto& b) { return a.strength < b.strength; });
    brightest[series.lasers[i]] = best->at;
    spacing[series.lasers[i]] = (lines.back().at - lines.front().at) / static_cast<double>(lines.size() - 1);
  }
  const Result<std::vector<double>> drawn =
      FindFirstEstimates(series, camera, options.first_estimates, context);
  std::map<int, double> places;
  if (drawn.ok()) places = AssignFirstEstimates(*drawn, brightest);
  if (places.empty()) {
    warnings->push_back("laserFirstEstimates shows " + std::to_string(drawn.ok() ? drawn->size() : 0) +
                        " lines for " + std::to_string(series.lasers.size()) +
                        " lasers; the brightest stripe of each laser is taken as its central one");
    return brightest;
  }
  for (const auto& [laser, x] : places) {
    if (std::abs(x - brightest[laser]) < 0.5 * spacing[laser]) continue;
    warnings->push_back(
        "laser " + std::to_string(laser) +
        ": the brightest stripe is not the one nearest to its drawn line; the drawn line decides");
  }
  return places;
}

// Direction of the world's x: perpendicular to the reference laser's central stripe at the origin.
double CentralTurn(const DiffractedFan& fan) {
  // Where order 0 crosses y = +-h on the backplane, by Newton's method on x.
  const auto x_at = [&](double y) {
    double x = fan.origin.x();
    for (int i = 0; i < 30; ++i) {
      const auto here = Locate(fan, {x, y, 0.0}), there = Locate(fan, {x + 1e-3, y, 0.0});
      if (!here || !there) return x;
      const double slope = (there->Order(fan) - here->Order(fan)) / 1e-3;
      const double change = here->Order(fan) / slope;
      x -= change;
      if (std::abs(change) < 1e-12) break;
    }
    return x;
  };
  constexpr double kReach = 5.0;  // mm
  return -std::atan((x_at(kReach) - x_at(-kReach)) / (2.0 * kReach));
}

void TurnWorld(double angle, BundleState* state) {
  Rigid3 new_from_old;
  new_from_old.rotation = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Rigid3 camera = RigidFromPose(state->camera_from_world);
  state->camera_from_world = PoseFromRigid(camera * new_from_old.Inverse());
  for (PoseParameters& pose : state->world_from_board)
    pose = PoseFromRigid(new_from_old * RigidFromPose(pose));
  for (FanParameters& p : state->fans) {
    DiffractedFan fan = GeometryFromFan(p);
    fan.origin = new_from_old * fan.origin;
    fan.a = new_from_old.rotation * fan.a;
    fan.b = new_from_old.rotation * fan.b;
    fan.n = new_from_old.rotation * fan.n;
    p = FanFromGeometry(fan);
  }
  for (auto& plane : state->planes) {
    const Eigen::Vector2d slope =
        new_from_old.rotation.topLeftCorner<2, 2>() * Eigen::Vector2d(plane[1], plane[2]);
    plane[1] = slope.x();
    plane[2] = slope.y();
  }
}

// Share of each picture's stripe points that fit an order.
std::vector<double> AssignedShares(const std::vector<SheetPicture>& pictures,
                                   const std::vector<SheetPoint>& points,
                                   const SheetAssignmentOptions& options) {
  std::vector<double> shares(pictures.size(), 0.0);
  for (const SheetPoint& p : points) shares[static_cast<std::size_t>(p.source)] += 1.0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    double all = 0.0;
    for (const StripeSegment& s : pictures[i].stripes.segments) {
      const int inner = s.count - 2 * options.end_rows;
      if (inner > 0) all += std::ceil(static_cast<double>(inner) / options.every_rows);
    }
    shares[i] = all > 0.0 ? shares[i] / all : 0.0;
  }
  return shares;
}

// How far the height of a point seen along the same ray moves when the sheet moves by 1 mm.
double HeightPerMm(const BundleCalibration& c, const SheetPoint& p, const Eigen::Vector3d& at) {
  const DiffractedFan& fan = *c.device.lasers[static_cast<std::size_t>(p.laser)].fan;
  const Eigen::Vector3d back = (c.device.camera.Center() - at).normalized();
  const auto here = Locate(fan, at), along = Locate(fan, at + back / back.z());  // 1 mm higher
  if (!here || !along) return 0.0;
  const double orders_per_height = std::abs(along->Order(fan) - here->Order(fan));
  return orders_per_height > 1e-9 ? p.orders_per_px / p.mm_per_px / orders_per_height : 0.0;
}

std::vector<SheetResidual> Residuals(const BundleCalibration& c) {
  std::vector<SheetResidual> out;
  for (const SheetPoint& p : c.data.points) {
    const BundleState& s = c.solution.state;
    const Eigen::Vector3d at = bundle::PointOnPlane<double>(
        s.lens.value.data(), s.camera_from_world.start, s.camera_from_world.value.data(),
        s.planes[static_cast<std::size_t>(p.plane)].data(), {p.u, p.v});
    SheetResidual r;
    r.laser = c.device.lasers[static_cast<std::size_t>(p.laser)].laser;
    r.order = p.order;
    r.picture = p.source;
    r.height_mm = c.data.planes[static_cast<std::size_t>(p.plane)].given_mm;
    r.x_mm = at.x();
    r.y_mm = at.y();
    r.miss_mm = OrderMiss(s, p) / p.orders_per_px * p.mm_per_px;
    r.sd_mm = p.sd_px * p.mm_per_px;
    r.height_per_mm = HeightPerMm(c, p, at);
    out.push_back(r);
  }
  return out;
}

// One calibration on its way.
class Bundler {
 public:
  Bundler(const CalibrationSeries& series, const BundleOptions& options, const Context& context)
      : series_(series), options_(options), problem_(options.problem), context_(context) {}

  Result<BundleCalibration> Run(const CameraCalibration& camera) {
    DORSUM_RETURN_IF_ERROR(CollectBoards(series_, camera, context_, &out_));
    out_.data.planes = PlanesOfSeries(series_);
    DORSUM_ASSIGN_OR_RETURN(pictures_, FindSheetPictures(series_, options_.pictures, context_));
    for (const SheetPicture& p : pictures_) {
      out_.pictures.push_back(p.name);
      out_.laser_of_picture.push_back(p.laser);
    }
    DORSUM_RETURN_IF_ERROR(SolveBoards(camera.camera));
    DORSUM_RETURN_IF_ERROR(StartSheets());
    DORSUM_RETURN_IF_ERROR(SolveSheets());
    DORSUM_RETURN_IF_ERROR(CheckAndRepeat());
    Finish();
    return std::move(out_);
  }

 private:
  // Camera and boards alone, which says how well corners are found, whether the board is flat, and how high
  // the calibration object really is.
  Status SolveBoards(const Camera& camera) {
    context_.Report("bundle: boards", 0.3);
    BundleProblemOptions boards = problem_;
    boards.use_points = false;
    DORSUM_ASSIGN_OR_RETURN(solution_,
                            SolveBundle(out_.data, StartState(camera, out_.data), boards, context_));
    std::vector<double> errors = ViewErrors(out_.data, solution_.state);
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    problem_.corner_sd_px = std::clamp(*middle / std::sqrt(2.0), 0.03, 1.0);
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
        CentralPlaces(series_, camera, pictures_, options_, context_, &out_.warnings);
    for (std::size_t i = 0; i < series_.lasers.size(); ++i) {
      const int index = static_cast<int>(i);
      const auto place = central.find(series_.lasers[i]);
      DORSUM_ASSIGN_OR_RETURN(
          const SheetStart start,
          EstimateSheets(camera, FindPicture(pictures_, index, "backplane")->stripes,
                         FindPicture(pictures_, index, "Closer")->stripes, solution_.state.planes[1][0],
                         place == central.end() ? std::nullopt : std::optional(place->second),
                         options_.start));
      solution_.state.fans.push_back(FanFromGeometry(start.fan));
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
    out_.data.points = AssignOrders(pictures_, solution_.state, assignment);
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
    TurnWorld(CentralTurn(GeometryFromFan(solution_.state.fans[reference])), &solution_.state);
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

Result<BundleCalibration> CalibrateBundle(const CalibrationSeries& series, const CameraCalibration& camera,
                                          const BundleOptions& options, const Context& context) {
  context.Report("stripes on planes", 0.0);
  return Bundler(series, options, context).Run(camera);
}

}  // namespace dorsum
