// SPDX-License-Identifier: Apache-2.0
#include "simulator/board.h"

#include <algorithm>
#include <cmath>

#include "simulator/mottle.h"

namespace dorsum {
namespace {

constexpr double kWhite = 0.82, kBlack = 0.045;

// Mean over [x - w/2, x + w/2] of the wave that is 1 on [0, 1), -1 on [1, 2), and so on.
double FilteredSquareWave(double x, double w) {
  const auto integral = [](double t) {
    const double phase = t - 2.0 * std::floor(0.5 * t);
    return phase < 1.0 ? phase : 2.0 - phase;
  };
  return (integral(x + 0.5 * w) - integral(x - 0.5 * w)) / w;
}

// Share of [x - w/2, x + w/2] that lies within [-half, half].
double Coverage(double x, double half, double w) {
  return std::max(0.0, std::min(x + 0.5 * w, half) - std::max(x - 0.5 * w, -half)) / w;
}

Paint Printed(double dark, double white) {
  return {dark > 0.5 ? Material::kBoardBlack : Material::kBoardWhite, white + dark * (kBlack - white)};
}

// What a part shows without the new print.
Pattern PatternOf(const ScenePart& part) {
  if (part.pattern) return part.pattern;
  return [paint = part.paint, mottle = part.mottle](const Eigen::Vector3d& world, double) {
    return Paint{paint.material, paint.albedo * (1.0 + mottle * Mottle(world))};
  };
}

double MarginOf(const BoardDesign& board) { return board.square_mm; }

}  // namespace

Eigen::Vector2d BoardSheetSize(const BoardDesign& board) {
  return board.square_mm * Eigen::Vector2d(board.columns + 1, board.rows + 1) +
         2.0 * MarginOf(board) * Eigen::Vector2d::Ones();
}

Pattern ChessboardPattern(const BoardDesign& board, const Rigid3& world_from_board, const Pattern& around) {
  const Eigen::Vector2d half_sheet = 0.5 * BoardSheetSize(board);
  return [board, half_sheet, around, board_from_world = world_from_board.Inverse()](
             const Eigen::Vector3d& world, double footprint_mm) -> Paint {
    const Eigen::Vector3d p = board_from_world * world;
    const bool off_plane = std::abs(p.z()) > 0.01;
    if (off_plane || std::abs(p.x()) > half_sheet.x() || std::abs(p.y()) > half_sheet.y()) {
      return around(world, footprint_mm);
    }
    const double w = std::clamp(footprint_mm / board.square_mm, 1e-6, 1.0);
    const double x = p.x() / board.square_mm, y = p.y() / board.square_mm;
    const double half_x = 0.5 * (board.columns + 1), half_y = 0.5 * (board.rows + 1);
    const double checker = FilteredSquareWave(x + half_x, w) * FilteredSquareWave(y + half_y, w);
    const double inside = Coverage(x, half_x, w) * Coverage(y, half_y, w);
    return Printed(inside * 0.5 * (1.0 + checker), kWhite);
  };
}

ScenePart ChessboardPlate(const BoardDesign& board, const Rigid3& world_from_board) {
  ScenePart plate = WhitePlate(world_from_board, BoardSheetSize(board));
  LayChessboard(board, world_from_board, plate);
  return plate;
}

void LayChessboard(const BoardDesign& board, const Rigid3& world_from_board, ScenePart& part) {
  part.pattern = ChessboardPattern(board, world_from_board, PatternOf(part));
}

void DrawLines(const std::vector<DrawnLine>& lines, ScenePart& part) {
  part.pattern = [lines, under = PatternOf(part)](const Eigen::Vector3d& world,
                                                  double footprint_mm) -> Paint {
    const Paint paper = under(world, footprint_mm);
    double dark = 0.0;
    for (const DrawnLine& line : lines) {
      const Eigen::Vector3d d = world - line.middle;
      const double along = line.direction.dot(d);
      const double across = (d - along * line.direction).norm();
      dark = std::max(dark, Coverage(along, 0.5 * line.length_mm, footprint_mm) *
                                Coverage(across, 0.5 * line.width_mm, footprint_mm));
    }
    return dark > 0.0 ? Printed(dark, paper.albedo) : paper;
  };
}

}  // namespace dorsum
