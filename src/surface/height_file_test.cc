// SPDX-License-Identifier: Apache-2.0
#include "surface/height_file.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/json.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

HeightField SmallField() {
  HeightField field;
  field.origin_mm = {-12.5, 3.25};
  field.pitch_mm = 0.5;
  field.z = cv::Mat1f(3, 4, 17.125F);
  field.z(0, 0) = -1.0e-3F;
  field.z(1, 2) = std::numeric_limits<float>::quiet_NaN();
  field.z(2, 3) = 80.0F;
  return field;
}

TEST(HeightFileTest, HeightsComeBackAsFloatsWithTheirHoles) {
  const TempFolder dir;
  const HeightField field = SmallField();
  ASSERT_TRUE(WriteHeightField(dir.path(), field).ok());
  const cv::Mat read = cv::imread((dir / "height.tiff").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.type(), CV_32FC1);
  ASSERT_EQ(read.size(), field.z.size());
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) {
      const float z = read.at<float>(r, c);
      EXPECT_TRUE(z == field.z(r, c) || (std::isnan(z) && std::isnan(field.z(r, c)))) << r << ", " << c;
    }
  }
}

TEST(HeightFileTest, SaysWhereTheFieldLies) {
  const TempFolder dir;
  ASSERT_TRUE(WriteHeightField(dir.path(), SmallField()).ok());
  const auto json = ReadJson(dir / "height.json");
  ASSERT_TRUE(json.ok()) << json.error().message;
  EXPECT_EQ((*json)["schema"], "dorsum/height");
  EXPECT_EQ((*json)["origin_mm"], Json({-12.5, 3.25}));
  EXPECT_EQ((*json)["pitch_mm"], 0.5);
  EXPECT_EQ((*json)["columns"], 4);
  EXPECT_EQ((*json)["rows"], 3);
}

TEST(HeightFileTest, AnEmptyFieldWritesNothing) {
  const TempFolder dir;
  EXPECT_TRUE(WriteHeightField(dir.path(), HeightField{}).ok());
  EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
}

TEST(HeightFileTest, AFolderThatIsNotThereIsSaid) {
  const TempFolder dir;
  const Status status = WriteHeightField(dir / "none", SmallField());
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
}

}  // namespace
}  // namespace dorsum
