// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_skin.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simulator/surface_nets.h"

namespace dorsum {
namespace {

HandShape Person(std::uint64_t seed, Sex sex = Sex::kMan) {
  Rng rng(seed);
  return SampleHandShape(sex, rng);
}

TEST(HandSkinTest, NothingLiesBelowThePlane) {
  const HandSkin skin(Person(1), HandPose());
  for (double x = -150; x < 100; x += 3) {
    for (double y = -60; y < 100; y += 3) EXPECT_GT(skin.Distance({x, y, -0.01}), 0);
  }
}

TEST(HandSkinTest, BoundsHoldTheSkin) {
  for (std::uint64_t seed : {1, 2, 3}) {
    Rng rng(seed);
    const HandSkin skin(Person(seed), SampleHandPose(rng));
    Eigen::Vector3d lo, hi;
    skin.Bounds(lo, hi);
    for (double s = 0; s <= 1; s += 0.01) {
      for (double t = 0; t <= 1; t += 0.02) {
        const double x = lo.x() + s * (hi.x() - lo.x()), y = lo.y() + s * (hi.y() - lo.y());
        const double z = lo.z() + t * (hi.z() - lo.z());
        for (double across : {lo.y(), hi.y()}) EXPECT_GT(skin.Distance({x, across, z}), 0);
        for (double along : {lo.x(), hi.x()}) EXPECT_GT(skin.Distance({along, y, z}), 0);
        EXPECT_GT(skin.Distance({x, lo.y() + t * (hi.y() - lo.y()), hi.z()}), 0);
      }
    }
  }
}

TEST(HandSkinTest, EverySampledPersonHasASkin) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed + 5000);
    const HandSkin skin(Person(seed, seed % 2 ? Sex::kMan : Sex::kWoman), SampleHandPose(rng));
    // The thumb's web is the palm's own flesh where a short crotch meets a fleshy hand.
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(skin.Distance(skin.Skeleton().crotches[i]), 0, i == 0 ? 6.0 : 1.5) << "seed " << seed;
    }
  }
}

// The crotches are found where the shape says, by walking out of the web along x at its height.
TEST(HandSkinTest, WebsEndAtTheCrotchHeights) {
  for (std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    Rng rng(seed);
    const HandPose pose = SampleHandPose(rng);
    const HandSkin skin(Person(seed, seed % 2 ? Sex::kMan : Sex::kWoman), pose);
    for (int i = 1; i < 4; ++i) {
      const Eigen::Vector3d crotch = skin.Skeleton().crotches[i];
      EXPECT_NEAR(skin.Distance(crotch), 0, 0.5) << "seed " << seed << " crotch " << i;
      EXPECT_LT(skin.Distance(crotch - Eigen::Vector3d(6, 0, 0)), 0);
      EXPECT_GT(skin.Distance(crotch + Eigen::Vector3d(6, 0, 0)), 0);
    }
  }
}

TEST(HandSkinTest, DistanceIsSmoothAcrossTheSkin) {
  const HandSkin skin(Person(2), HandPose());
  auto distance = [&](const Eigen::Vector3d& p) { return skin.Distance(p); };
  const FingerBones& middle = skin.Skeleton().fingers[1];
  // Down onto the skin at places of the back of the hand and fingers: slope near one, the same from both
  // steps.
  int steep = 0, count = 0;
  for (double x = -90; x < middle.tip.x() - 5; x += 1.7) {
    for (double y : {-20.0, -8.0, 0.0, 2.0, 9.0, 24.0}) {
      Eigen::Vector3d p(x, y, 60);
      for (int i = 0; i < 60; ++i) p.z() -= 0.7 * skin.Distance(p);
      if (p.z() < 4 || std::abs(skin.Distance(p)) > 1e-3) continue;
      const Eigen::Vector3d coarse = Gradient(distance, p, 0.03), fine = Gradient(distance, p, 0.003);
      EXPECT_LT((coarse - fine).norm(), 0.05);  // most in a wrinkle
      ++count;
      steep += std::abs(fine.norm() - 1) > 0.2;
    }
  }
  EXPECT_GT(count, 300);
  EXPECT_LT(steep, count / 20);
}

// Guards against parts that are switched off while they still reach the skin.
TEST(HandSkinTest, DistanceHasNoSteps) {
  for (std::uint64_t seed : {11, 12}) {
    Rng rng(seed);
    const HandSkin skin(Person(seed), SampleHandPose(rng));
    constexpr double kStep = 0.02;
    for (double z : {9.0, 18.0, 27.0}) {
      for (double y = -45; y < 90; y += 7.3) {
        double before = skin.Distance({-100 - 2 * kStep, y, z}), middle = skin.Distance({-100 - kStep, y, z});
        for (double x = -100; x < 100; x += kStep) {
          const double after = skin.Distance({x, y, z});
          if (std::abs(after) < 0.3) {  // in the air between two fingers details may switch sides
            EXPECT_LT(std::abs(after - 2 * middle + before), 0.002) << x << " " << y << " " << z;
          }
          before = middle;
          middle = after;
        }
      }
    }
  }
}

TEST(HandSkinTest, NailsArePalerThanCreases) {
  const HandShape shape = Person(3);
  const HandSkin skin(shape, HandPose());
  auto on_top = [&](const Eigen::Vector3d& at) {
    Eigen::Vector3d p(at.x(), at.y(), 60);
    for (int i = 0; i < 80; ++i) p.z() -= 0.7 * skin.Distance(p);
    return p;
  };
  const FingerBones& f = skin.Skeleton().fingers[1];
  const Eigen::Vector2d nail = f.tip.head<2>() - (1.6 + 0.5 * shape.fingers[1].nail_length) * f.direction;
  const Eigen::Vector3f on_nail = skin.Albedo(on_top({nail.x(), nail.y(), 0}));
  Eigen::Vector3f darkest = Eigen::Vector3f::Ones();
  for (double s = -5; s <= 5; s += 0.2) {
    const Eigen::Vector2d at = f.pip.head<2>() + s * f.direction;
    const Eigen::Vector3f here = skin.Albedo(on_top({at.x(), at.y(), 0}));
    if (here.x() < darkest.x()) darkest = here;
  }
  EXPECT_GT(on_nail.x(), 1.1f * darkest.x());
  EXPECT_GT(on_nail.y(), 1.2f * darkest.y());
  EXPECT_GT(on_nail.x(), on_nail.z());  // skin, not paint
}

}  // namespace
}  // namespace dorsum
