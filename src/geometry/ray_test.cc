// SPDX-License-Identifier: Apache-2.0
#include "geometry/ray.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(Ray, MeetsAPlaneAtTheDistanceAlongIt) {
  const Ray ray{{1.0, 2.0, 10.0}, Eigen::Vector3d(3.0, 0.0, -4.0) / 5.0};
  const auto t = Intersect(ray, Plane{Eigen::Vector3d::UnitZ(), 2.0});
  ASSERT_TRUE(t.has_value());
  const double distance = t.value_or(0.0);
  EXPECT_NEAR(distance, 10.0, 1e-12);
  EXPECT_LT((ray.At(distance) - Eigen::Vector3d(7.0, 2.0, 2.0)).norm(), 1e-12);
}

TEST(Ray, BehindItselfOrAlongThePlaneItMeetsNothing) {
  const Plane ground{Eigen::Vector3d::UnitZ(), 0.0};
  EXPECT_FALSE(Intersect(Ray{{0.0, 0.0, 1.0}, Eigen::Vector3d::UnitZ()}, ground).has_value());
  EXPECT_FALSE(Intersect(Ray{{0.0, 0.0, 1.0}, Eigen::Vector3d::UnitX()}, ground).has_value());
  EXPECT_TRUE(Intersect(Ray{{0.0, 0.0, -1.0}, Eigen::Vector3d::UnitZ()}, ground).has_value());
}

TEST(Ray, APlaneTellsItsSides) {
  const Plane plane{Eigen::Vector3d(0.6, 0.0, 0.8), 5.0};
  EXPECT_NEAR(plane.SignedDistance({3.0, 9.0, 4.0}), 0.0, 1e-12);
  EXPECT_NEAR(plane.SignedDistance({3.6, 0.0, 4.8}), 1.0, 1e-12);
  EXPECT_NEAR(plane.SignedDistance(Eigen::Vector3d::Zero()), -5.0, 1e-12);
}

}  // namespace
}  // namespace dorsum
