// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge.h"

#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "stripes/synthetic_stripes_test.h"

namespace dorsum {
namespace {

Context Threads(int n) {
  Context context;
  context.threads = n;
  return context;
}

SyntheticStripeDesign Few() {
  SyntheticStripeDesign design;
  design.width = 400;
  design.height = 200;
  design.stripes = 6;
  design.peak = 120.0;
  return design;
}

// One upright stripe whose light ends beyond the edge; blurred as a lens does.
cv::Mat CutStripe(double u, double width, const std::function<double(int)>& right_edge) {
  Rng rng(7);
  cv::Mat image(160, 100, CV_8UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int x = 0; x < image.cols; ++x) {
      const double t = (x - u) / width;
      const double lit = 0.5 * std::erfc((x - right_edge(v)) / (0.8 * std::sqrt(2.0)));
      const double grey = 4.0 + 120.0 * std::exp(-0.5 * t * t) * lit + 1.0 * rng.Normal();
      image.at<std::uint8_t>(v, x) = static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 255.0)));
    }
  }
  return image;
}

TEST(Ridge, NoiseAloneShowsNoStripes) {
  SyntheticStripeDesign design = Few();
  design.peak = 0.0;
  design.noise_sd = 3.0;
  EXPECT_TRUE(FindRidges(RenderSyntheticStripes(design).image, cv::Mat(), 0, {}, {}).points.empty());
  EXPECT_TRUE(FindRidges(cv::Mat(50, 50, CV_8UC1, cv::Scalar(0)), cv::Mat(), 0, {}, {}).points.empty());
  EXPECT_TRUE(FindRidges(cv::Mat(3, 50, CV_8UC1, cv::Scalar(9)), cv::Mat(), 0, {}, {}).points.empty());
}

TEST(Ridge, MeasuresWidthAndPeakAndOnePointPerRow) {
  const SyntheticStripes scene = RenderSyntheticStripes(Few());
  const LaserStripes found = FindRidges(scene.image, cv::Mat(), 2, {}, {});
  EXPECT_EQ(found.laser, 2);
  EXPECT_EQ(found.segments.size(), 6U);
  std::set<std::tuple<int, int>> rows;
  for (const StripePoint& p : found.points) {
    EXPECT_TRUE(rows.emplace(p.segment, static_cast<int>(p.v)).second);
    EXPECT_NEAR(p.width, 2.0, 1.0);
    EXPECT_GT(p.sd_px, 0.0F);
    EXPECT_GT(p.peak, 5.0F);
  }
}

TEST(Ridge, LooksAtTheRegionOnly) {
  const SyntheticStripes scene = RenderSyntheticStripes(Few());
  cv::Mat region = cv::Mat::zeros(scene.image.size(), CV_8UC1);
  region(cv::Rect(0, 60, 200, 80)) = 255;
  const LaserStripes found = FindRidges(scene.image, region, 0, {}, {});
  EXPECT_GT(found.points.size(), 200U);
  for (const StripePoint& p : found.points) {
    EXPECT_GE(p.v, 60.0F);
    EXPECT_LT(p.v, 140.0F);
    EXPECT_LT(p.u, 201.0F);
  }
}

TEST(Ridge, AStripeThatAnEdgeCutsIsNotPulledAside) {
  const double u = 50.3;
  // The edge runs obliquely through the stripe; its middle leaves the surface at row 100.
  const cv::Mat image = CutStripe(u, 2.2, [u](int v) { return u + (100 - v) * 0.08; });
  const LaserStripes found = FindRidges(image, cv::Mat(), 0, {}, {});
  double worst = 0.0, last = 0.0;
  for (const StripePoint& p : found.points) {
    worst = std::max(worst, std::abs(static_cast<double>(p.u) - u));
    last = std::max(last, static_cast<double>(p.v));
  }
  EXPECT_LT(worst, 0.6);
  EXPECT_GT(last, 82.0);
  EXPECT_LT(last, 104.0);
}

TEST(Ridge, AStripeEndsWhereItsLightEnds) {
  cv::Mat image = RenderSyntheticStripes(Few()).image.clone();
  cv::Mat dark = image.rowRange(120, 200);
  dark = cv::Scalar(4);
  const LaserStripes found = FindRidges(image, cv::Mat(), 0, {}, {});
  EXPECT_FALSE(found.points.empty());
  for (const StripePoint& p : found.points) EXPECT_LT(p.v, 120.0F);
  for (const StripeSegment& s : found.segments) EXPECT_GE(s.max_v, 117.0F);
}

TEST(Ridge, SameBytesAtAnyNumberOfThreads) {
  const SyntheticStripes scene = RenderSyntheticStripes(Few());
  const LaserStripes one = FindRidges(scene.image, cv::Mat(), 0, {}, Threads(1));
  const LaserStripes four = FindRidges(scene.image, cv::Mat(), 0, {}, Threads(4));
  ASSERT_EQ(one.points.size(), four.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    ASSERT_EQ(one.points[i].u, four.points[i].u);
    ASSERT_EQ(one.points[i].sd_px, four.points[i].sd_px);
    ASSERT_EQ(one.points[i].segment, four.points[i].segment);
  }
}

}  // namespace
}  // namespace dorsum
