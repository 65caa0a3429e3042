// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "captures/device_description.h"
#include "geometry/rigid3.h"
#include "simulator/scene.h"

namespace dorsum {

// A printed chessboard in the plane z = 0 of its own frame, its middle at the origin and the rows of inner
// corners along x; a square of white paper around it, and beyond that what `around` says.
Pattern ChessboardPattern(const BoardDesign& board, const Rigid3& world_from_board, const Pattern& around);

// Size of the board's paper, margin included.
Eigen::Vector2d BoardSheetSize(const BoardDesign& board);

// The board on a thin plate, in any pose.
ScenePart ChessboardPlate(const BoardDesign& board, const Rigid3& world_from_board);

// The board as a sheet that lies on a flat part: paints the part, since paper has no thickness here.
void LayChessboard(const BoardDesign& board, const Rigid3& world_from_board, ScenePart& part);

// One dark thin line, drawn on a part.
struct DrawnLine {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  // unit
  double length_mm = 150.0;
  double width_mm = 1.2;
};
void DrawLines(const std::vector<DrawnLine>& lines, ScenePart& part);

}  // namespace dorsum
