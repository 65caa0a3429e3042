// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_support.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

const PlateSupportOptions kOptions{
    .step_px = 1.0, .mm_per_px = 1.0, .max_beyond_mm = 4.0, .max_gap_mm = 16.0};

// Two bars of 100 x 20 px, 10 px apart.
cv::Mat Bars() {
  cv::Mat mask(80, 140, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(20, 10, 100, 20)).setTo(255);
  mask(cv::Rect(20, 40, 100, 20)).setTo(255);
  return mask;
}

std::vector<PlateSample> Column(float u, int first, int last) {
  std::vector<PlateSample> out;
  for (int v = first; v <= last; ++v) out.push_back({u, static_cast<float>(v), 5.0F, 1.0F});
  return out;
}

bool IsActive(const PlateLattice& l, int u, int v) {
  return l.active(v - static_cast<int>(l.v0), u - static_cast<int>(l.u0)) != 0;
}

TEST(PlateSupportTest, GapsCloseAndEndsGoOnAsFarAsAsked) {
  const Outline outline(Bars(), 4);
  std::vector<PlateSample> samples = Column(50.0F, 10, 29);
  for (const float u : {65.0F, 90.0F}) {
    const std::vector<PlateSample> more = Column(u, 10, 29);
    samples.insert(samples.end(), more.begin(), more.end());
  }
  const PlateLattice l = MakeSupport(samples, outline, kOptions);
  for (int u = 47; u <= 68; ++u) EXPECT_TRUE(IsActive(l, u, 20)) << u;  // 15 mm apart: closed
  EXPECT_FALSE(IsActive(l, 77, 20));                                    // 25 mm apart: open
  EXPECT_TRUE(IsActive(l, 93, 20));
  EXPECT_FALSE(IsActive(l, 96, 20));
  EXPECT_TRUE(IsActive(l, 50, 9));   // the outline's cells need their outer corners
  EXPECT_FALSE(IsActive(l, 50, 7));  // and no more
}

TEST(PlateSupportTest, DistancesDoNotCrossFromFingerToFinger) {
  const Outline outline(Bars(), 4);
  PlateSupportOptions far = kOptions;
  far.max_beyond_mm = 15.0;
  far.max_gap_mm = 40.0;
  const PlateLattice l = MakeSupport(Column(60.0F, 10, 29), outline, far);
  EXPECT_TRUE(IsActive(l, 60, 25));
  EXPECT_FALSE(IsActive(l, 60, 42));  // 13 mm from a sample, but of the other bar
}

TEST(PlateSupportTest, MediansStartWhereAMinorityIsWrong) {
  const Outline outline(Bars(), 4);
  std::vector<PlateSample> samples = Column(60.0F, 10, 29);
  for (std::size_t i = 0; i < samples.size(); i += 4) samples[i].z = 45.0F;
  PlateLattice l = MakeSupport(samples, outline, {.step_px = 4.0, .mm_per_px = 1.0});
  StartFromMedians(samples, {}, &l);
  for (int r = 0; r < l.z.rows; ++r) {
    for (int c = 0; c < l.z.cols; ++c) {
      EXPECT_EQ(l.z(r, c), l.active(r, c) != 0 ? 5.0F : 0.0F);
    }
  }
}

}  // namespace
}  // namespace dorsum
