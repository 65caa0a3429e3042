// SPDX-License-Identifier: Apache-2.0
#include "jobs/evaluate.h"

#include <cmath>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// Writes what evaluate reads of a reconstruction: points one pixel and one millimetre apart on rows 10 to 49,
// laser 0 on even columns and 1 on odd ones, and a mask of those rows and columns.
using Height = std::function<double(double x, double y)>;
void WriteOutput(const fs::path& dir, const Height& z) {
  fs::create_directories(dir);
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8UC1);
  mask(cv::Rect(10, 10, 60, 40)) = 255;
  ASSERT_TRUE(cv::imwrite((dir / "mask.png").string(), mask));
  SurfacePoints points;
  for (int v = 10; v < 50; ++v) {
    for (int u = 10; u < 70; ++u) {
      SurfacePoint p;
      p.position = {u - 40.0, 30.0 - v, z(u - 40.0, 30.0 - v)};
      p.laser = static_cast<std::uint8_t>(u % 2);
      p.u = static_cast<float>(u);
      p.v = static_cast<float>(v);
      points.push_back(p);
    }
  }
  ASSERT_TRUE(WritePointsPly(dir / "points.ply", points).ok());
}

EvaluateRequest PlaneAt(const fs::path& dir, double height) {
  EvaluateRequest request;
  request.out_dirs = {dir};
  request.plane_height_mm = height;
  return request;
}

TEST(EvaluateTest, FiguresAreThoseOfTheEquations) {
  const TempFolder dir;
  // Laser 0 is 0.3 mm too high, laser 1 alternates between 20.4 and 19.6 mm from row to row.
  WriteOutput(dir / "out", [](double x, double y) {
    const bool even = static_cast<int>(x + 40.0) % 2 == 0;
    return even ? 20.3 : 20.0 + (static_cast<int>(30.0 - y) % 2 == 0 ? 0.4 : -0.4);
  });
  const auto evaluation = Evaluate(PlaneAt(dir / "out", 20.0), {});
  ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
  const auto& models = evaluation->captures.at(0).models;
  ASSERT_EQ(models.size(), 3U);
  EXPECT_EQ(models[0].model, "laser 0");
  EXPECT_NEAR(models[0].rmse_mm, 0.3, 1e-5);
  EXPECT_NEAR(models[0].bias_mm, 0.3, 1e-5);
  EXPECT_NEAR(models[1].rmse_mm, 0.4, 1e-5);
  EXPECT_NEAR(models[1].bias_mm, 0.0, 1e-5);
  EXPECT_NEAR(models[1].range_mm, 0.8, 1e-5);
  EXPECT_NEAR(models[1].nrmse, 0.5, 1e-4) << "RMSE over the range of z";
  EXPECT_EQ(models[2].model, "merged");
  EXPECT_NEAR(models[2].rmse_mm, std::sqrt((0.09 + 0.16) / 2.0), 1e-5);
  EXPECT_NEAR(models[2].p95_abs_mm, 0.4, 1e-5);
  EXPECT_EQ(models[0].points + models[1].points, models[2].points);
}

// The mask's rim of 3 px is left out, and no point within is.
TEST(EvaluateTest, TakesAllPointsOfTheShrunkMask) {
  const TempFolder dir;
  WriteOutput(dir / "out", [](double x, double y) { return x == 0.0 && y == 0.0 ? 70.0 : 20.0; });
  EvaluateRequest request = PlaneAt(dir / "out", 20.0);
  const auto merged = [&] { return Evaluate(request, {})->captures[0].models.back(); };
  EXPECT_EQ(merged().points, 54U * 34U);
  EXPECT_NEAR(merged().rmse_mm, 50.0 / std::sqrt(54.0 * 34.0), 1e-4) << "an outlier was thrown away";
  request.shrink_px = 0.0;
  EXPECT_EQ(merged().points, 60U * 40U);
}

TEST(EvaluateTest, RepeatsAreComparedInPairs) {
  const TempFolder dir;
  EvaluateRequest request = PlaneAt(dir / "a", 20.0);
  for (const auto& [name, z] : {std::pair{"a", 20.1}, {"b", 20.4}, {"c", 19.9}}) {
    WriteOutput(dir / name, [height = z](double, double) { return height; });
    if (name[0] != 'a') request.out_dirs.push_back(dir / name);
  }
  const auto evaluation = Evaluate(request, {});
  ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
  ASSERT_EQ(evaluation->differences.size(), 9U) << "three pairs of three models";
  for (const RepeatDifference& d : evaluation->differences) {
    EXPECT_NEAR(d.diff_mm, d.first == "a" && d.second == "c" ? 0.0 : 0.3, 1e-5) << d.first << d.second;
  }
}

TEST(EvaluateTest, AReferenceMeshThatIsTooSmallIsSaid) {
  const TempFolder dir;
  WriteOutput(dir / "out", [](double, double) { return 20.5; });
  TriangleMesh mesh;
  mesh.vertices = {{-100, -100, 20}, {0, -100, 20}, {0, 100, 20}, {-100, 100, 20}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  ASSERT_TRUE(WriteMeshPly(dir / "half.ply", mesh).ok());
  EvaluateRequest request;
  request.out_dirs = {dir / "out"};
  request.against = dir / "half.ply";
  auto evaluation = Evaluate(request, {});
  ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
  const ModelErrors& merged = evaluation->captures[0].models.back();
  EXPECT_NEAR(merged.rmse_mm, 0.5, 1e-5);
  EXPECT_EQ(merged.outside, 26U * 34U) << "columns with x from 1 to 26";

  for (auto& v : mesh.vertices) v.x() -= 500.0;
  ASSERT_TRUE(WriteMeshPly(dir / "half.ply", mesh).ok());
  evaluation = Evaluate(request, {});
  ASSERT_FALSE(evaluation.ok());
  EXPECT_EQ(evaluation.error().code, ErrorCode::kBadInput);
}

TEST(EvaluateTest, FitsAShapeToAllLasersTogether) {
  const TempFolder dir;
  WriteOutput(dir / "out", [](double x, double) { return std::sqrt(50.0 * 50.0 - x * x); });
  EvaluateRequest request;
  request.out_dirs = {dir / "out"};
  request.fit = Shape::kCylinder;
  const auto evaluation = Evaluate(request, {});
  ASSERT_TRUE(evaluation.ok()) << evaluation.error().message;
  ASSERT_TRUE(evaluation->captures[0].shape);
  EXPECT_NEAR(evaluation->captures[0].shape->radius_mm, 50.0, 1e-3);
  EXPECT_LT(evaluation->captures[0].models.back().rmse_mm, 1e-4);
  const Json json = EvaluationToJson(*evaluation);
  EXPECT_EQ(json["captures"][0]["shape"]["kind"], "cylinder");
  EXPECT_NE(EvaluationToText(*evaluation).find("cylinder of radius 50.0"), std::string::npos);
}

TEST(EvaluateTest, TakesExactlyOneWayOfJudging) {
  EvaluateRequest request;
  request.out_dirs = {"anywhere"};
  EXPECT_EQ(Evaluate(request, {}).error().code, ErrorCode::kUsage);
  request.plane_height_mm = 1.0;
  request.fit = Shape::kPlane;
  EXPECT_EQ(Evaluate(request, {}).error().code, ErrorCode::kUsage);
}

TEST(EvaluateTest, AFolderWithoutItsFilesIsBadInput) {
  const TempFolder dir;
  for (const char* file : {"points.ply", "mask.png"}) {
    WriteOutput(dir / "out", [](double, double) { return 20.0; });
    fs::remove(dir / "out" / file);
    const auto evaluation = Evaluate(PlaneAt(dir / "out", 20.0), {});
    ASSERT_FALSE(evaluation.ok());
    EXPECT_EQ(evaluation.error().code, ErrorCode::kBadInput);
    EXPECT_NE(evaluation.error().message.find(file), std::string::npos) << evaluation.error().message;
  }
}

}  // namespace
}  // namespace dorsum
