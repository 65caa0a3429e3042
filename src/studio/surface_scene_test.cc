// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_scene.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "studio/orbit_camera.h"
#include "studio/shapes_test.h"

namespace dorsum {
namespace {

Ray Down(double x, double y) { return {{x, y, 300.0}, {0.0, 0.0, -1.0}}; }

TEST(SurfaceScene, APlaneIsPickedWhereTheRayMeetsIt) {
  Scan scan;
  scan.surface.mesh = PlaneMesh(21, 1.0, [](double x, double) { return 10.0 + 0.5 * x; });
  const std::optional<Picked> picked = Pick(scan, Down(3.3, -4.1), Shown::kMesh, 0.0);
  ASSERT_TRUE(picked && picked->face);
  EXPECT_NEAR((picked->position - Eigen::Vector3d(3.3, -4.1, 11.65)).norm(), 0.0, 1e-9);
  EXPECT_FALSE(picked->image);  // without a camera nobody knows
  EXPECT_FALSE(Pick(scan, Down(30.0, 0.0), Shown::kMesh, 0.0));
  EXPECT_FALSE(Pick(scan, Down(3.3, -4.1), Shown::kPoints, 0.01));
}

TEST(SurfaceScene, OfASphereTheNearSideIsPicked) {
  Scan scan;
  scan.surface.mesh = SphereMesh(40.0, 60);
  OrbitCamera camera;
  camera.Frame({-40, -40, -40}, {40, 40, 40});
  const Ray ray = camera.Through(0.0, 0.0, 1.5);
  const std::optional<Picked> picked = Pick(scan, ray, Shown::kMesh, 0.0);
  ASSERT_TRUE(picked);
  EXPECT_NEAR((picked->position + 40.0 * ray.direction).norm(), 0.0, 0.2);
}

TEST(SurfaceScene, AnAimedPointIsPickedWithItsImagePlaceAndAHiddenOneIsNot) {
  Scan scan;
  SurfacePoint front, back;
  front.position = {1.0, 1.0, 20.0};
  front.u = 100.0F;
  front.v = 50.0F;
  back.position = {1.0, 1.0, -30.0};
  scan.surface.points = {back, front};
  const std::optional<Picked> picked = Pick(scan, Down(1.2, 1.0), Shown::kPoints, 0.005);
  ASSERT_TRUE(picked && picked->point && picked->image);
  EXPECT_EQ(*picked->point, 1U);
  EXPECT_EQ(*picked->image, Eigen::Vector2d(100.0, 50.0));
  EXPECT_FALSE(Pick(scan, Down(9.0, 1.0), Shown::kPoints, 0.005));
}

TEST(SurfaceScene, PointsThatAreNoNumbersAreNeitherDrawnNorPicked) {
  Scan scan;
  SurfacePoint good, bad;
  bad.position.setConstant(std::numeric_limits<double>::quiet_NaN());
  bad.u = bad.v = std::numeric_limits<float>::quiet_NaN();
  scan.surface.points = {bad, good, bad};
  const SceneBuffers buffers = MakeBuffers(scan.surface, ColourBy::kHeight, {});
  EXPECT_EQ(buffers.points.size(), 1U);
  EXPECT_TRUE(buffers.low.allFinite());
  EXPECT_EQ(Pick(scan, Down(0.0, 0.0), Shown::kBoth, 0.01)->point, 1U);
  EXPECT_EQ(PickInImage(scan.surface.points, {0.0, 0.0}, {}, 5.0), 1U);
  EXPECT_TRUE(MakeBuffers({}, ColourBy::kOrder, {}).points.empty());
}

TEST(SurfaceScene, AFewOfThePointsAreSpreadOverAll) {
  Reconstruction surface;
  for (int i = 0; i < 1000; ++i) {
    SurfacePoint p;
    p.position.x() = i;
    surface.points.push_back(p);
  }
  const SceneBuffers buffers = MakeBuffers(surface, ColourBy::kShaded, {});
  std::set<float> all, tenths;
  for (std::size_t i = 0; i < buffers.points.size(); ++i) {
    all.insert(buffers.points[i].position[0]);
    if (i < 50) tenths.insert(std::floor(buffers.points[i].position[0] / 100.0F));
  }
  EXPECT_EQ(all.size(), 1000U);
  EXPECT_EQ(tenths.size(), 10U);
}

TEST(SurfaceScene, AStripeOfTheImageIsTheStripeOfTheSurface) {
  SurfacePoints points;
  for (int order = -1; order <= 1; ++order) {
    for (int row = 9; row >= 0; --row) {
      SurfacePoint p;
      p.order = static_cast<std::int16_t>(order);
      p.u = 100.0F + 20.0F * static_cast<float>(order);
      p.v = static_cast<float>(row);
      points.push_back(p);
    }
  }
  const auto found = PickInImage(points, {121.0, 4.2}, 0, 6.0);
  ASSERT_TRUE(found);
  EXPECT_EQ(points[*found].order, 1);
  const std::vector<std::uint32_t> stripe = PointsOfStripe(points, KeyOf(points[*found]));
  ASSERT_EQ(stripe.size(), 10U);
  EXPECT_EQ(points[stripe.front()].v, 0.0F);
  EXPECT_EQ(points[stripe.back()].v, 9.0F);
  EXPECT_FALSE(PickInImage(points, {110.0, 4.2}, 0, 6.0));
  EXPECT_FALSE(PickInImage(points, {121.0, 4.2}, 1, 6.0));  // that laser has none
}

TEST(SurfaceScene, TheDifferenceToAnotherSurfaceIsItsHeightAboveIt) {
  Reconstruction ours, other, other_points;
  ours.mesh = PlaneMesh(21, 1.0, [](double, double) { return 5.0; });
  other.mesh = PlaneMesh(11, 1.0, [](double, double) { return 4.75; });
  for (const Eigen::Vector3d& v : other.mesh.vertices) {
    SurfacePoint p;
    p.position = v;
    other_points.points.push_back(p);
  }
  const SceneBuffers buffers = MakeBuffers(ours, ColourBy::kDifference, MakeOtherHeight(other));
  EXPECT_EQ(buffers.difference.compared, 121U);
  EXPECT_EQ(buffers.difference.outside, 441U - 121U);
  EXPECT_NEAR(buffers.difference.mean_mm, 0.25, 1e-6);
  EXPECT_NEAR(buffers.difference.rms_mm, 0.25, 1e-6);
  EXPECT_NEAR(buffers.scale.low, -buffers.scale.high, 1e-12);
  EXPECT_NEAR(*MakeOtherHeight(other_points)(0.2, 0.2), 4.75, 1e-9);
  EXPECT_FALSE(MakeOtherHeight(other_points)(40.0, 0.2));
}

TEST(SurfaceScene, AMeshTakesItsOrdersFromTheStripesNearby) {
  Reconstruction surface;
  surface.mesh = PlaneMesh(21, 1.0, [](double, double) { return 0.0; });
  SurfacePoint p;
  p.order = 3;
  p.position = {0.4, 0.0, 0.0};
  surface.points = {p};
  const std::vector<float> values = VertexValues(surface, ColourBy::kOrder, {});
  int carried = 0;
  for (const float v : values) carried += v == 3.0F ? 1 : 0;
  EXPECT_GT(carried, 100);  // within 6 mm
  EXPECT_LT(carried, 125);
  const ColourScale scale = MakeScale(ColourBy::kOrder, values, {});
  EXPECT_EQ(scale.classes.size(), 1U);
  EXPECT_EQ(scale.At(3.0), OrderColour(3));
}

TEST(OrbitCamera, ARayThroughAPlaceOfTheViewLandsThereAgain) {
  OrbitCamera camera;
  camera.Frame({-50, -30, 0}, {50, 70, 40});
  camera.Turn(33.0, -20.0);
  camera.Pan(0.1, -0.2);
  camera.Zoom(1.7);
  for (const double x : {-0.8, 0.0, 0.6}) {
    const Ray ray = camera.Through(x, 0.3, 1.6);
    const Eigen::Vector4f clip =
        camera.ClipFromWorld(1.6) * ray.At(camera.distance()).cast<float>().homogeneous();
    EXPECT_NEAR(clip.x() / clip.w(), x, 1e-4);
    EXPECT_NEAR(clip.y() / clip.w(), 0.3, 1e-4);
    EXPECT_LT(std::abs(clip.z() / clip.w()), 1.0F);
  }
  camera.Home();
  EXPECT_EQ(camera.yaw_deg(), 0.0);
  EXPECT_EQ(camera.target(), Eigen::Vector3d(0, 20, 20));
}

}  // namespace
}  // namespace dorsum
