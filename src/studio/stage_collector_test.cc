// SPDX-License-Identifier: Apache-2.0
#include "studio/stage_collector.h"

#include <algorithm>
#include <atomic>

#include <gtest/gtest.h>

#include "studio/fixture_scan_test.h"

namespace dorsum {
namespace {

bool Has(const StageComparison& c, const std::string& key) {
  return std::find(c.keys.begin(), c.keys.end(), key) != c.keys.end();
}

TEST(StageCollector, KeepsACopyEightBitsDeep) {
  StageCollector collector;
  cv::Mat picture(4, 6, CV_32FC1, cv::Scalar(1.0F));
  picture.at<float>(0, 0) = -1.0F;
  collector.Image("a/b", picture);
  picture.setTo(0.0F);
  collector.Image("empty", {});
  const auto images = collector.Take();
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images.at("a/b").type(), CV_8UC1);
  EXPECT_EQ(images.at("a/b").at<unsigned char>(0, 0), 0);
  EXPECT_EQ(images.at("a/b").at<unsigned char>(3, 3), 255);
}

TEST(CompareStages, BothChainsShowTheirStagesAndAChangeIsFound) {
  const auto scan = FixtureScan(ScanFixture::kBox);
  const auto first = CompareStages(*scan, {}, nullptr, {});
  ASSERT_TRUE(first.ok()) << first.error().message;
  const StageComparison& c = **first;
  ASSERT_FALSE(c.ours.error) << c.ours.error->message;
  ASSERT_FALSE(c.classic.error) << c.classic.error->message;
  EXPECT_EQ(c.ours.points, scan->surface.points.size());
  EXPECT_GT(c.classic.points, 1000U);
  for (const char* key : {"mask/mask", "stripes/0/points", "orders/0", "orders/2", "points/1", "heights"}) {
    SCOPED_TRACE(key);
    ASSERT_TRUE(Has(c, key));
    for (const ChainStages* chain : {&c.classic, &c.ours}) {
      ASSERT_TRUE(chain->pictures.count(key));
      EXPECT_EQ(chain->pictures.at(key).depth(), CV_8U);
    }
  }
  EXPECT_TRUE(c.classic.pictures.count("stripes/2/mask"));
  EXPECT_FALSE(c.ours.pictures.count("stripes/2/mask"));
  EXPECT_LT(std::find(c.keys.begin(), c.keys.end(), "mask/mask"),
            std::find(c.keys.begin(), c.keys.end(), "heights"));
  EXPECT_TRUE(c.changed.empty());

  ReconstructOptions options;
  options.stripe_mask.offset += 6.0;
  const auto second = CompareStages(*scan, options, &c, {});
  ASSERT_TRUE(second.ok());
  EXPECT_TRUE((*second)->changed.count("stripes/0/mask"));
  EXPECT_FALSE((*second)->changed.count("mask/mask")) << "it does not hang on the stripes";
}

TEST(CompareStages, AChainThatFailsIsToldBesideTheOther) {
  const auto scan = FixtureScan(ScanFixture::kBox);
  ReconstructOptions options;
  options.hand_mask.min_contrast = 255.0;  // no object stands out that much; only the classic mask asks
  const auto result = CompareStages(*scan, options, nullptr, {});
  ASSERT_TRUE(result.ok());
  ASSERT_TRUE((*result)->classic.error);
  EXPECT_FALSE((*result)->classic.error->message.empty());
  EXPECT_TRUE((*result)->classic.pictures.count("mask/difference")) << "as far as it went";
  EXPECT_FALSE((*result)->ours.error);
}

TEST(CompareStages, CancellingAndAMereSurfaceAreErrors) {
  const auto scan = FixtureScan(ScanFixture::kBox);
  const std::atomic<bool> cancel = true;
  Context context;
  context.cancel = &cancel;
  const auto cancelled = CompareStages(*scan, {}, nullptr, context);
  ASSERT_FALSE(cancelled.ok());
  EXPECT_EQ(cancelled.error().code, ErrorCode::kCancelled);
  const auto none = CompareStages(Scan{}, {}, nullptr, {});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().message.find("calibration"), std::string::npos);
}

}  // namespace
}  // namespace dorsum
