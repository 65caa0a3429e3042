// SPDX-License-Identifier: Apache-2.0
#include "calibration/camera_calibration.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>
#include <opencv2/calib3d.hpp>

#include "base/parallel.h"
#include "calibration/chessboard.h"
#include "calibration/opencv_results.h"
#include "captures/green_channel.h"

namespace dorsum {
namespace {

// The board's rows lie along growing image v, so its own z points away from the camera; ours points towards
// it.
Rigid3 CameraFromWorld(const Rigid3& camera_from_board) {
  Rigid3 board_from_world;
  board_from_world.rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return camera_from_board * board_from_world;
}

// Greatest angle between the board's normals in two views. Views of boards that all lie alike leave the focal
// length open (Zhang 2000, section 3.1), however small their reprojection error is.
double GreatestTurn(const std::vector<cv::Mat>& rvecs) {
  std::vector<Eigen::Vector3d> normals;
  normals.reserve(rvecs.size());
  for (const cv::Mat& rvec : rvecs)
    normals.emplace_back(PoseFromSolver(rvec, cv::Mat::zeros(3, 1, CV_64F)).rotation.col(2));
  double least = 1.0;
  for (const auto& a : normals) {
    for (const auto& b : normals) least = std::min(least, a.dot(b));
  }
  return std::acos(std::clamp(least, -1.0, 1.0));
}

struct View {
  std::optional<std::vector<cv::Point2f>> corners;
  Status status;
};

std::vector<View> FindBoards(const CalibrationSeries& series, cv::Size inner, const Context& context) {
  std::vector<View> views(series.chess_views.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(views.size()), [&](std::int64_t i) {
    const auto index = static_cast<std::size_t>(i);
    if (context.IsCancelled()) return;
    const Result<cv::Mat> image = series.Read(series.chess_views[index], Channels::kGreen);
    if (!image.ok()) {
      views[index].status = image.error();
    } else {
      views[index].corners = FindChessboard(*image, inner);
    }
  });
  return views;
}

void Judge(const CameraCalibrationOptions& options, double rms, CameraCalibration* out) {
  PartReport& report = out->report;
  report.part = "camera";
  report.figures = {{"views", static_cast<double>(out->views.size()), ""},
                    {"reprojection error", rms, "px"},
                    {"worst view", *std::max_element(out->view_rms_px.begin(), out->view_rms_px.end()), "px"},
                    {"focal length", out->camera.fx, "px"},
                    {"camera height", out->camera.Center().z(), "mm"}};
  if (rms <= options.good_rms_px) {
    report.verdict = "the camera model explains all chessboards";
  } else if (rms <= options.doubtful_rms_px) {
    report.grade = Grade::kDoubtful;
    report.verdict = "the corners do not fit well; is the board flat, sharp and still?";
  } else {
    report.grade = Grade::kBad;
    report.verdict =
        "the corners do not fit; capture the chessboards again with a flat board and a sharp picture";
  }
}

}  // namespace

Result<CameraCalibration> CalibrateCamera(const CalibrationSeries& series,
                                          const CameraCalibrationOptions& options, const Context& context) {
  const cv::Size inner(series.setup.board_columns, series.setup.board_rows);
  const std::vector<View> views = FindBoards(series, inner, context);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  CameraCalibration out;
  std::vector<std::vector<cv::Point3f>> board_points;
  for (std::size_t i = 0; i < views.size(); ++i) {
    DORSUM_RETURN_IF_ERROR(views[i].status);
    const auto& corners = views[i].corners;
    if (!corners) {
      out.warnings.push_back("no chessboard of " + std::to_string(inner.width) + "x" +
                             std::to_string(inner.height) + " inner corners is seen whole in " +
                             series.chess_views[i] + "; going on without it");
      if (i == 0) {
        return BadInput("no chessboard of " + std::to_string(inner.width) + "x" +
                        std::to_string(inner.height) + " inner corners is seen in " + series.chess_views[0] +
                        ", which fixes the world; capture it again or correct setup.json");
      }
      continue;
    }
    out.views.push_back(series.chess_views[i]);
    out.corners.push_back(*corners);
    board_points.push_back(ChessboardPoints(inner, series.setup.square_mm));
  }
  if (static_cast<int>(out.views.size()) < options.min_views) {
    return BadInput("a chessboard is seen in only " + std::to_string(out.views.size()) + " of " +
                    std::to_string(views.size()) + " views; at least " + std::to_string(options.min_views) +
                    " are needed, so capture the chessboards again");
  }
  cv::Mat matrix, distortion, intrinsic_sd, extrinsic_sd, view_errors;
  std::vector<cv::Mat> rvecs, tvecs;
  double rms = 0.0;
  try {
    rms = cv::calibrateCamera(board_points, out.corners, {series.setup.width, series.setup.height}, matrix,
                              distortion, rvecs, tvecs, intrinsic_sd, extrinsic_sd, view_errors, 0,
                              {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-12});
  } catch (const cv::Exception&) {
    return BadInput(
        "the chessboard views do not determine the camera; capture them again with the board tilted "
        "differently in each");
  }
  Camera& camera = out.camera;
  camera.width = series.setup.width;
  camera.height = series.setup.height;
  camera.fx = Settled(matrix.at<double>(0, 0));
  camera.fy = Settled(matrix.at<double>(1, 1));
  camera.cx = Settled(matrix.at<double>(0, 2));
  camera.cy = Settled(matrix.at<double>(1, 2));
  for (std::size_t i = 0; i < 5; ++i)
    camera.distortion[i] = Settled(distortion.at<double>(static_cast<int>(i)));
  camera.camera_from_world = CameraFromWorld(PoseFromSolver(rvecs[0], tvecs[0]));
  if (!std::isfinite(rms) || !camera.Center().allFinite() || camera.Center().z() <= 0.0) {
    return BadInput(
        "the chessboard views do not determine the camera; capture them again with the board tilted "
        "differently in each");
  }
  if (GreatestTurn(rvecs) < options.min_turn) {
    return BadInput(
        "the chessboard lies alike in all views, which leaves the focal length open; capture chess00, "
        "chess01, "
        "… again with the board tilted differently in each");
  }
  for (int i = 0; i < view_errors.rows; ++i) out.view_rms_px.push_back(Settled(view_errors.at<double>(i)));
  Judge(options, Settled(rms), &out);
  return out;
}

Camera MoveWorld(const Camera& camera, const Eigen::Vector3d& origin, double angle) {
  Rigid3 old_from_new;
  old_from_new.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  old_from_new.translation = origin;
  Camera moved = camera;
  moved.camera_from_world = camera.camera_from_world * old_from_new;
  return moved;
}

}  // namespace dorsum
