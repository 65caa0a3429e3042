// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_calibration.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <opencv2/calib3d.hpp>

#include "base/parallel.h"
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

BundleState StartState(const CalibrationSeries& series, const Camera& camera, const BundleData& data) {
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
  (void)series;
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
    out.push_back(r);
  }
  return out;
}

}  // namespace

Result<BundleCalibration> CalibrateBundle(const CalibrationSeries& series, const CameraCalibration& camera,
                                          const BundleOptions& options, const Context& context) {
  BundleCalibration out;
  context.Report("stripes on planes", 0.0);
  DORSUM_RETURN_IF_ERROR(CollectBoards(series, camera, context, &out));
  out.data.planes = PlanesOfSeries(series);
  DORSUM_ASSIGN_OR_RETURN(const std::vector<SheetPicture> pictures,
                          FindSheetPictures(series, options.pictures, context));
  for (const SheetPicture& p : pictures) out.pictures.push_back(p.name);

  context.Report("bundle: boards", 0.3);
  BundleProblemOptions boards_only = options.problem;
  boards_only.use_points = false;
  DORSUM_ASSIGN_OR_RETURN(
      BundleSolution solution,
      SolveBundle(out.data, StartState(series, camera.camera, out.data), boards_only, context));

  const Camera first = solution.state.GetCamera();
  const std::map<int, double> central =
      CentralPlaces(series, first, pictures, options, context, &out.warnings);
  for (std::size_t i = 0; i < series.lasers.size(); ++i) {
    const int index = static_cast<int>(i);
    const auto place = central.find(series.lasers[i]);
    DORSUM_ASSIGN_OR_RETURN(
        const SheetStart start,
        EstimateSheets(first, FindPicture(pictures, index, "backplane")->stripes,
                       FindPicture(pictures, index, "Closer")->stripes, out.data.planes[1].given_mm,
                       place == central.end() ? std::nullopt : std::optional(place->second), options.start));
    solution.state.fans.push_back(FanFromGeometry(start.fan));
  }

  // Each round predicts better, so that it may believe less.
  constexpr double kTolerances[] = {0.25, 0.12, 0.06};
  for (std::size_t round = 0; round < std::size(kTolerances); ++round) {
    context.Report("bundle: light sheets", 0.4 + 0.2 * static_cast<double>(round));
    SheetAssignmentOptions assignment = options.assignment;
    assignment.tolerance = kTolerances[round];
    BundleProblemOptions problem = options.problem;
    problem.move_camera = round + 1 == std::size(kTolerances);
    problem.uncertainties = problem.move_camera;
    if (!problem.move_camera) assignment.every_rows *= 2;
    out.data.points = AssignOrders(pictures, solution.state, assignment);
    DORSUM_ASSIGN_OR_RETURN(solution, SolveBundle(out.data, solution.state, problem, context));
  }

  const auto one = std::find(series.lasers.begin(), series.lasers.end(), 1);
  const auto reference =
      static_cast<std::size_t>(one == series.lasers.end() ? 0 : one - series.lasers.begin());
  TurnWorld(CentralTurn(GeometryFromFan(solution.state.fans[reference])), &solution.state);
  out.solution = std::move(solution);
  out.device.camera = out.solution.state.GetCamera();
  for (std::size_t i = 0; i < series.lasers.size(); ++i) {
    LaserGeometry laser;
    laser.laser = series.lasers[i];
    laser.fan = GeometryFromFan(out.solution.state.fans[i]);
    laser.grating = laser.fan->origin;
    out.device.lasers.push_back(laser);
  }
  out.residuals = Residuals(out);
  for (LaserGeometry& laser : out.device.lasers) {
    laser.min_order = 1000;
    laser.max_order = -1000;
    for (const SheetResidual& r : out.residuals) {
      if (r.laser != laser.laser || r.height_mm != 0.0) continue;
      laser.min_order = std::min(laser.min_order, r.order);
      laser.max_order = std::max(laser.max_order, r.order);
    }
  }
  out.view_rms_px = ViewErrors(out.data, out.solution.state);
  out.parts = JudgeBundle(out, options.verdicts);
  return out;
}

}  // namespace dorsum
