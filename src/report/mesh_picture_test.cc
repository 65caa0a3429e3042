// SPDX-License-Identifier: Apache-2.0
#include "report/mesh_picture.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "report/colours.h"

namespace dorsum {
namespace {

// The upper part of a sphere of 50 mm radius, cut 20 mm below its top, over a square grid.
TriangleMesh SphereCap() {
  TriangleMesh mesh;
  constexpr int kSide = 41, kMiddle = kSide / 2;
  cv::Mat1i index(kSide, kSide, -1);
  for (int r = 0; r < kSide; ++r) {
    for (int c = 0; c < kSide; ++c) {
      const double x = 2.0 * (c - kMiddle), y = 2.0 * (r - kMiddle), square = x * x + y * y;
      if (square > 1600.0) continue;
      index(r, c) = static_cast<int>(mesh.vertices.size());
      mesh.vertices.emplace_back(x, y, std::sqrt(2500.0 - square) - 20.0);
    }
  }
  const auto at = [&](int r, int c) { return index(r, c); };
  for (int r = 0; r + 1 < kSide; ++r) {
    for (int c = 0; c + 1 < kSide; ++c) {
      if (at(r, c) < 0 || at(r, c + 1) < 0 || at(r + 1, c) < 0 || at(r + 1, c + 1) < 0) continue;
      const auto v = [&](int dr, int dc) { return static_cast<std::uint32_t>(at(r + dr, c + dc)); };
      mesh.faces.push_back({v(0, 0), v(0, 1), v(1, 1)});
      mesh.faces.push_back({v(0, 0), v(1, 1), v(1, 0)});
    }
  }
  return mesh;
}

double Brightness(const cv::Mat& picture, cv::Point at) {
  return cv::sum(cv::mean(picture(cv::Rect(at.x - 5, at.y - 5, 10, 10))))[0];
}

const MeshPictureOptions kSmall{.size = {200, 200}, .samples = 2, .floor = false};

TEST(MeshPicture, ACapIsBrighterTowardsTheLightAndNothingIsAround) {
  const cv::Mat picture = RenderMesh(SphereCap(), {0.0, 90.0}, kSmall);
  ASSERT_EQ(picture.size(), cv::Size(200, 200));
  EXPECT_GT(Brightness(picture, {60, 60}), Brightness(picture, {140, 140}) + 100.0);
  const cv::Mat empty = RenderMesh({}, {0.0, 90.0}, kSmall);
  EXPECT_EQ(picture.at<Colour>(5, 5), empty.at<Colour>(5, 5));
  EXPECT_EQ(picture.at<Colour>(195, 195), empty.at<Colour>(195, 195));
  EXPECT_NE(picture.at<Colour>(100, 100), empty.at<Colour>(100, 100));
}

TEST(MeshPicture, SeenFromAboveXIsRightAndYIsUp) {
  TriangleMesh mesh;  // an L whose long leg lies along +y, on the left
  mesh.vertices = {{0, 0, 1}, {30, 0, 1}, {30, 20, 1}, {0, 20, 1}, {10, 20, 1}, {10, 100, 1}, {0, 100, 1}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {3, 4, 5}, {3, 5, 6}};
  const cv::Mat picture = RenderMesh(mesh, {0.0, 90.0}, kSmall), empty = RenderMesh({}, {0.0, 90.0}, kSmall);
  EXPECT_NE(picture.at<Colour>(30, 82), empty.at<Colour>(30, 82));      // the leg's end, above left
  EXPECT_EQ(picture.at<Colour>(30, 118), empty.at<Colour>(30, 118));    // nothing above right
  EXPECT_NE(picture.at<Colour>(180, 118), empty.at<Colour>(180, 118));  // the foot, below right
}

TEST(MeshPicture, TheSamePictureOnOneAndManyThreads) {
  Context one, many;
  one.threads = 1;
  many.threads = 4;
  const TriangleMesh mesh = SphereCap();
  const cv::Mat a = RenderMesh(mesh, kFrontView, {.size = {160, 120}}, one);
  const cv::Mat b = RenderMesh(mesh, kFrontView, {.size = {160, 120}}, many);
  EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0.0);
}

TEST(MeshPicture, TheFloorShowsAGridAndAShadow) {
  MeshPictureOptions options = kSmall;
  options.floor = true;
  const cv::Mat with = RenderMesh(SphereCap(), kFrontView, options);
  const cv::Mat without = RenderMesh(SphereCap(), kFrontView, kSmall);
  cv::Mat difference;
  cv::absdiff(with, without, difference);
  EXPECT_GT(cv::countNonZero(difference.reshape(1) > 10), 500);
}

TEST(MeshPicture, OddMeshesAreNotACrash) {
  TriangleMesh mesh = SphereCap();
  mesh.vertices[10].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(RenderMesh(mesh, kBackView, {.size = {60, 40}, .colour_by_height = true}).empty());
  TriangleMesh point;
  point.vertices = {{1.0, 2.0, 3.0}};
  EXPECT_FALSE(RenderMesh(point, kBackView, {.size = {60, 40}}).empty());
  point.faces = {{0, 1, 2}};
  EXPECT_THROW(RenderMesh(point, kBackView, {.size = {60, 40}}), std::logic_error);
}

}  // namespace
}  // namespace dorsum
