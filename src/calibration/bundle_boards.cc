// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_boards.h"

#include <cstddef>
#include <cstdint>

#include <opencv2/calib3d.hpp>

#include "base/parallel.h"
#include "calibration/chessboard.h"
#include "calibration/opencv_results.h"
#include "captures/green_channel.h"
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
  cv::Mat rvec, tvec;
  cv::solvePnP(object, image, matrix, distortion, rvec, tvec);
  return camera.camera_from_world.Inverse() * PoseFromSolver(rvec, tvec);
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
    const Result<cv::Mat> image = series.Read(view.name, Channels::kGreen);
    if (!image.ok()) {
      status[static_cast<std::size_t>(i)] = image.error();
    } else if (const auto corners = FindChessboard(*image, inner)) {
      view.corners = ToEigen(*corners);
    }
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  return views;
}

// Of the pairs that FindLyingBoards() gives: the board on the calibration object lies above the one on the
// backplane.
Status CheckClosenessOf(const std::vector<BoardView>& lying, const CalibrationSeries& series,
                        const Camera& camera, const std::vector<Eigen::Vector3d>& board) {
  for (std::size_t i = 0; i + 1 < lying.size(); i += 2) {
    const BoardView &further = lying[i], &closer = lying[i + 1];
    if (further.corners.empty() || closer.corners.empty()) continue;
    const auto height = [&](const BoardView& view) {
      return PlaceBoard(camera, board, view.corners).translation.z();
    };
    if (height(closer) > height(further)) continue;
    return BadInput(
        "the chessboard under laser " + std::to_string(series.lasers[i / 2]) +
        " does not lie higher on the calibration object than on the backplane; are the Closer and "
        "Further images swapped?");
  }
  return {};
}

}  // namespace

Status CollectBoards(const CalibrationSeries& series, const CameraCalibration& camera, const Context& context,
                     BundleData* data, std::vector<std::string>* warnings) {
  const cv::Size inner(series.setup.board_columns, series.setup.board_rows);
  for (const cv::Point3f& p : ChessboardPoints(inner, series.setup.square_mm)) {
    data->board_points.emplace_back(p.x, -p.y, 0.0);  // the image's v runs against the world's y
  }
  for (std::size_t i = 0; i < camera.views.size(); ++i) {
    data->boards.push_back({camera.views[i], ToEigen(camera.corners[i]), i == 0 ? 0 : -1});
  }
  DORSUM_ASSIGN_OR_RETURN(const std::vector<BoardView> lying, FindLyingBoards(series, context));
  for (const BoardView& view : lying) {
    if (view.corners.empty()) {
      warnings->push_back("no chessboard of " + std::to_string(inner.width) + "x" +
                          std::to_string(inner.height) + " inner corners is seen whole in " + view.name +
                          "; going on without it");
    } else {
      data->boards.push_back(view);
    }
  }
  return CheckClosenessOf(lying, series, camera.camera, data->board_points);
}

BundleState StartOfBoards(const Camera& camera, const BundleData& data) {
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

}  // namespace dorsum
