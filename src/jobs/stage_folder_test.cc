// SPDX-License-Identifier: Apache-2.0
#include "jobs/stage_folder.h"

#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace dorsum {
namespace {

TEST(StageFolder, WritesEachStageUnderItsKey) {
  const std::filesystem::path dir = std::filesystem::path(testing::TempDir()) / "stage_folder_writes";
  std::filesystem::remove_all(dir);
  StageFolder stages(dir);
  Context context;
  context.sink = &stages;
  Sink(context, "stripes/2/mask", cv::Mat(4, 6, CV_8UC1, cv::Scalar(255)));
  ASSERT_TRUE(stages.status().ok());
  const cv::Mat read = cv::imread((dir / "stripes_2_mask.png").string(), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(read.size(), cv::Size(6, 4));
}

TEST(StageFolder, KeepsTheFirstFailure) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "stage_folder_is_a_file";
  std::ofstream(file) << "in the way";
  StageFolder stages(file / "stages");
  stages.Image("mask/mask", cv::Mat(2, 2, CV_8UC1, cv::Scalar(0)));
  ASSERT_FALSE(stages.status().ok());
  EXPECT_EQ(stages.status().error().code, ErrorCode::kBadInput);
}

}  // namespace
}  // namespace dorsum
