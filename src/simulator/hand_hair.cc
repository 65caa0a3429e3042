// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "base/random.h"
#include "simulator/hand_dressing.h"
#include "simulator/hand_skeleton.h"

namespace dorsum {
namespace {

constexpr double kWidth = 0.08;   // mm
constexpr double kDark = 0.25;    // of the skin's albedo
constexpr double kPerMm2 = 0.12;  // hairs
constexpr double kCell = 4.0;     // mm, of the grid that finds them

// One hair, seen from above: two straight pieces.
struct Hair {
  std::array<Eigen::Vector2d, 3> points;
};

double DistanceTo(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

// Hairs over a rectangle of the hand's frame, found by cell.
class Fur {
 public:
  Fur(const Eigen::AlignedBox2d& area, std::uint64_t seed)
      : area_(area),
        columns_(static_cast<int>(std::ceil(area.sizes().x() / kCell))),
        rows_(static_cast<int>(std::ceil(area.sizes().y() / kCell))),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    Rng rng(NamedSeed("hair", seed));
    const int count = static_cast<int>(kPerMm2 * area.volume());
    for (int i = 0; i < count; ++i) Add(Draw(rng));
  }

  // Share of the albedo that is left where a pixel sees `footprint_mm` around p.
  double Left(const Eigen::Vector2d& p, double footprint_mm) const {
    if (!area_.contains(p)) return 1.0;
    double left = 1.0;
    for (const int i : cells_[CellOf(p)]) {
      const auto& [a, b, c] = hairs_[static_cast<std::size_t>(i)].points;
      const double d = std::min(DistanceTo(p, a, b), DistanceTo(p, b, c));
      const double cover = std::clamp((0.5 * (footprint_mm + kWidth) - d) / footprint_mm, 0.0,
                                      std::min(1.0, kWidth / footprint_mm));
      left *= 1.0 - cover * (1.0 - kDark);
    }
    return left;
  }

 private:
  // Hairs grow towards the little finger's side and the elbow, more or less.
  Hair Draw(Rng& rng) const {
    const double x = rng.Uniform(area_.min().x(), area_.max().x()),
                 y = rng.Uniform(area_.min().y(), area_.max().y());
    const double angle = Radians(-150.0) + Radians(28.0) * rng.Normal(), bend = Radians(14.0) * rng.Normal();
    const double half = 0.5 * rng.Uniform(6.0, 14.0);
    const Eigen::Vector2d root(x, y),
        middle = root + half * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return {{root, middle, middle + half * Eigen::Vector2d(std::cos(angle + bend), std::sin(angle + bend))}};
  }

  void Add(const Hair& hair) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : hair.points) box.extend(p);
    const Eigen::Vector2d lo = box.min().array() - 0.5 * kCell, hi = box.max().array() + 0.5 * kCell;
    for (int row = RowOf(lo.y()); row <= RowOf(hi.y()); ++row) {
      for (int column = ColumnOf(lo.x()); column <= ColumnOf(hi.x()); ++column) {
        cells_[static_cast<std::size_t>(row * columns_ + column)].push_back(static_cast<int>(hairs_.size()));
      }
    }
    hairs_.push_back(hair);
  }

  int ColumnOf(double x) const {
    return std::clamp(static_cast<int>((x - area_.min().x()) / kCell), 0, columns_ - 1);
  }
  int RowOf(double y) const {
    return std::clamp(static_cast<int>((y - area_.min().y()) / kCell), 0, rows_ - 1);
  }
  std::size_t CellOf(const Eigen::Vector2d& p) const {
    return static_cast<std::size_t>(RowOf(p.y()) * columns_ + ColumnOf(p.x()));
  }

  Eigen::AlignedBox2d area_;
  int columns_, rows_;
  std::vector<Hair> hairs_;
  std::vector<std::vector<int>> cells_;
};

}  // namespace

void GrowHair(const PosedHand& hand, std::uint64_t seed, ScenePart& skin) {
  // Over forearm, back of the hand and the fingers' first links.
  const HandSkeleton bones = BuildSkeleton(hand.shape, hand.pose);
  const double front = bones.fingers[1].pip.x() - 6.0, side = 0.75 * hand.shape.hand_breadth;
  const Eigen::AlignedBox2d area(Eigen::Vector2d(bones.wrist.x() - 80.0, -side),
                                 Eigen::Vector2d(front, side));
  skin.strands = [fur = std::make_shared<const Fur>(area, seed),
                  hand_from_world = Eigen::Affine3d(WorldFromHand(hand.side, hand.pose).inverse())](
                     const Eigen::Vector3d& world, double footprint_mm) {
    const Eigen::Vector3d p = hand_from_world * world;
    return fur->Left(p.head<2>(), footprint_mm);
  };
}

}  // namespace dorsum
