// SPDX-License-Identifier: Apache-2.0
#include "report/photo_pictures.h"

#include <stdexcept>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "report/colours.h"

namespace dorsum {
namespace {

// A dark green photo with a darker disc, as the device takes them.
cv::Mat GreenPhoto() {
  cv::Mat photo(300, 400, CV_8UC3, cv::Scalar(4, 60, 2));
  cv::circle(photo, {200, 150}, 80, cv::Scalar(1, 20, 1), cv::FILLED);
  return photo;
}

LaserStripes Column(float u, std::optional<int> order, LaserStripes stripes = {}) {
  StripeSegment segment;
  segment.first = static_cast<std::int32_t>(stripes.points.size());
  segment.count = 200;
  segment.order = order;
  for (int row = 50; row < 250; ++row) stripes.points.push_back({.u = u, .v = static_cast<float>(row)});
  stripes.segments.push_back(segment);
  return stripes;
}

TEST(PhotoPictures, ADarkGreenPhotoBecomesBrightGrey) {
  const cv::Mat bright = BrightenPhoto(GreenPhoto());
  EXPECT_EQ(bright.size(), GreenPhoto().size());
  EXPECT_GT(bright.at<Colour>(5, 5)[0], 200);
  EXPECT_EQ(bright.at<Colour>(5, 5)[0], bright.at<Colour>(5, 5)[2]);
  EXPECT_TRUE(BrightenPhoto({}).empty());
}

TEST(PhotoPictures, MaskTintsItsInsideOnly) {
  cv::Mat mask = cv::Mat::zeros(300, 400, CV_8UC1);
  cv::circle(mask, {200, 150}, 80, cv::Scalar(255), cv::FILLED);
  const cv::Mat picture = DrawMask(GreenPhoto(), mask, {.width_px = 800});
  ASSERT_EQ(picture.size(), cv::Size(800, 600));
  const Colour inside = picture.at<Colour>(300, 400), outside = picture.at<Colour>(20, 20);
  EXPECT_GT(inside[0], inside[2] + 20);
  EXPECT_EQ(outside[0], outside[2]);
}

TEST(PhotoPictures, MaskOfAnotherSizeIsABrokenContract) {
  EXPECT_THROW(DrawMask(GreenPhoto(), cv::Mat::zeros(10, 10, CV_8UC1)), std::logic_error);
}

TEST(PhotoPictures, MissingPhotoOrMaskIsNotACrash) {
  EXPECT_TRUE(DrawMask({}, {}).empty());
  EXPECT_FALSE(DrawMask(GreenPhoto(), {}).empty());
  EXPECT_FALSE(DrawMask({}, cv::Mat::zeros(300, 400, CV_8UC1)).empty());
  EXPECT_FALSE(DrawIndexedStripes({}, {}).empty());
}

TEST(PhotoPictures, StripesHaveTheColourOfTheirOrderAtTheirPlace) {
  const LaserStripes stripes = Column(300.0F, std::nullopt, Column(200.0F, 3, Column(100.0F, 0)));
  const cv::Mat picture = DrawIndexedStripes(GreenPhoto(), stripes, {.width_px = 800});
  const int row = 110;  // away from numbers
  EXPECT_EQ(picture.at<Colour>(row, 200), OrderColour(0));
  EXPECT_LT(cv::norm(cv::Vec3d(picture.at<Colour>(row, 400)) - cv::Vec3d(OrderColour(3))), 90.0);
  const auto& unknown = picture.at<Colour>(row, 600);
  EXPECT_EQ(unknown[0], unknown[1]);
  EXPECT_EQ(unknown[1], unknown[2]);
}

TEST(PhotoPictures, ANumberInterruptsItsStripe) {
  const cv::Mat picture = DrawIndexedStripes(GreenPhoto(), Column(200.0F, 5), {.width_px = 800});
  const cv::Mat plate = picture(cv::Rect(394, 288, 12, 24));
  double low = 0.0, high = 0.0;
  cv::minMaxLoc(plate.reshape(1), &low, &high);
  EXPECT_LT(low, 20.0);
  EXPECT_GT(high, 120.0);
}

}  // namespace
}  // namespace dorsum
