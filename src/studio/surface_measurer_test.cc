// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_measurer.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include <gtest/gtest.h>

#include "studio/patience_test.h"
#include "studio/shapes_test.h"
#include "studio/surface_readout.h"

namespace dorsum {
namespace {

using Mode = SurfaceMeasurer::Mode;

// A ridge along y under one stripe that runs across it.
std::shared_ptr<const Scan> Ridge() {
  auto scan = std::make_shared<Scan>();
  const auto height = [](double x, double) { return 10.0 - std::abs(x); };
  scan->name = "ridge";
  scan->surface.mesh = PlaneMesh(41, 0.5, height);
  for (int i = 0; i <= 40; ++i) {
    SurfacePoint p;
    p.position = {0.5 * i - 10.0, 2.0, height(0.5 * i - 10.0, 2.0)};
    p.laser = 1;
    p.order = 3;
    p.v = static_cast<float>(i);
    scan->surface.points.push_back(p);
  }
  return scan;
}

class SurfaceMeasurerTest : public ::testing::Test {
 protected:
  SurfaceMeasurerTest() {
    QObject::connect(&measurer_, &SurfaceMeasurer::Failed, [this](const Error& e) { errors_.push_back(e); });
    measurer_.SetScan(scan_);
  }
  Picked Above(double x, double y) const {
    return *Pick(*measurer_.scan(), {{x, y, 300.0}, {0, 0, -1}}, Shown::kMesh, 0.0);
  }
  bool Rests() {
    return QTest::qWaitFor([&] { return !measurer_.busy(); }, kPatience_ms);
  }

  std::shared_ptr<const Scan> scan_ = Ridge();
  SurfaceMeasurer measurer_;
  std::vector<Error> errors_;
};

TEST_F(SurfaceMeasurerTest, APlaceIsAloneAndBringsItsStripe) {
  QSignalSpy changed(&measurer_, &SurfaceMeasurer::Changed);
  measurer_.Take(Above(5.1, 2.1));
  EXPECT_GT(changed.count(), 0);
  ASSERT_EQ(measurer_.places().size(), 1U);
  EXPECT_EQ(measurer_.stripe().size(), scan_->surface.points.size());
  EXPECT_EQ(measurer_.Marks().line.size(), measurer_.stripe().size());
  measurer_.Take(Above(-5.1, -8.1));
  EXPECT_EQ(measurer_.places().size(), 1U);
  EXPECT_TRUE(measurer_.stripe().empty());
  EXPECT_EQ(measurer_.Marks().places.size(), 1U);
}

TEST_F(SurfaceMeasurerTest, TwoPlacesAreMeasuredOneWayAndAtOnceTheOther) {
  measurer_.SetMode(Mode::kDistance);
  measurer_.Take(Above(-8.0, 0.3));
  EXPECT_FALSE(measurer_.busy());
  EXPECT_TRUE(SurfaceReadout(measurer_, nullptr, {}).startsWith("Click the second place."));
  measurer_.Take(Above(8.0, 0.3));
  EXPECT_TRUE(measurer_.busy());
  EXPECT_TRUE(SurfaceReadout(measurer_, nullptr, {}).contains("measuring along the surface"));
  ASSERT_TRUE(Rests());
  ASSERT_TRUE(measurer_.distance());
  EXPECT_NEAR(measurer_.distance()->along_mm, 16.0 * std::sqrt(2.0), 1e-3);
  EXPECT_TRUE(SurfaceReadout(measurer_, nullptr, {}).startsWith("Straight 16.00 mm, along the surface 22.6"));
  measurer_.SetMode(Mode::kSection);
  EXPECT_FALSE(measurer_.distance());
  ASSERT_TRUE(measurer_.section());
  EXPECT_EQ(measurer_.places().size(), 2U);
  // The section's line lies on the surface.
  for (const Eigen::Vector3d& p : measurer_.Marks().line) EXPECT_NEAR(p.z(), 10.0 - std::abs(p.x()), 1e-9);
  measurer_.Take(Above(1.0, 1.0));
  EXPECT_EQ(measurer_.places().size(), 1U);
  EXPECT_FALSE(measurer_.section());
  measurer_.SetMode(Mode::kPick);
  EXPECT_TRUE(measurer_.places().empty());
  EXPECT_TRUE(errors_.empty());
}

TEST_F(SurfaceMeasurerTest, ADistanceThatNobodyWaitsForAnyMoreIsNotShown) {
  measurer_.SetMode(Mode::kDistance);
  measurer_.Take(Above(-8.0, 0.3));
  measurer_.Take(Above(8.0, 0.3));
  measurer_.Clear();
  ASSERT_TRUE(Rests());
  EXPECT_FALSE(measurer_.distance());
  // The last of two in a row counts.
  measurer_.Take(Above(-8.0, 0.3));
  measurer_.Take(Above(8.0, 0.3));
  measurer_.Take(Above(0.0, -5.0));
  measurer_.Take(Above(0.0, 5.0));
  ASSERT_TRUE(QTest::qWaitFor([&] { return measurer_.distance().has_value(); }, kPatience_ms));
  EXPECT_NEAR(measurer_.distance()->along_mm, 10.0, 1e-3);
  EXPECT_TRUE(errors_.empty());
}

TEST_F(SurfaceMeasurerTest, WhatCannotBeMeasuredIsSaid) {
  measurer_.SetMode(Mode::kSection);
  measurer_.Take(Above(1.0, 1.0));
  measurer_.Take(Above(1.0, 1.0));
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_FALSE(measurer_.section());
  auto parts = std::make_shared<Scan>();
  TriangleMesh other = scan_->surface.mesh;
  parts->surface.mesh = other;
  const auto first = static_cast<std::uint32_t>(other.vertices.size());
  for (Eigen::Vector3d& v : other.vertices) v.y() += 50.0;
  for (auto face : other.faces) {
    for (std::uint32_t& i : face) i += first;
    parts->surface.mesh.faces.push_back(face);
  }
  parts->surface.mesh.vertices.insert(parts->surface.mesh.vertices.end(), other.vertices.begin(),
                                      other.vertices.end());
  measurer_.SetScan(parts);
  EXPECT_TRUE(measurer_.places().empty());
  measurer_.SetMode(Mode::kDistance);
  measurer_.Take(Above(0.0, 0.0));
  measurer_.Take(Above(0.0, 50.0));
  ASSERT_TRUE(Rests());
  EXPECT_EQ(errors_.size(), 2U);
  EXPECT_FALSE(measurer_.distance());
  measurer_.SetScan(nullptr);
  EXPECT_TRUE(SurfaceReadout(measurer_, nullptr, {}).isEmpty());
}

}  // namespace
}  // namespace dorsum
