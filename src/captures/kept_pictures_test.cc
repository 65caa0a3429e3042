// SPDX-License-Identifier: Apache-2.0
#include "captures/kept_pictures.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(KeptPictures, KeepsWhatItIsForAsLongAsThereIsRoom) {
  const cv::Mat small(10, 10, CV_8UC1, cv::Scalar(3)), large(10, 11, CV_8UC1, cv::Scalar(4));
  KeptPictures kept({"a", "b", "c"}, 200);
  kept.Put("other", small);
  kept.Put("a", small);
  kept.Put("b", large);  // 210 bytes together
  kept.Put("c", small);
  EXPECT_FALSE(kept.Find("other").has_value());
  EXPECT_FALSE(kept.Find("b").has_value());
  ASSERT_TRUE(kept.Find("a").has_value());
  EXPECT_EQ(kept.Find("a")->data, small.data);
  EXPECT_TRUE(kept.Find("c").has_value());
}

TEST(KeptPictures, TheFirstOfANameStays) {
  const cv::Mat first(2, 2, CV_8UC1, cv::Scalar(1)), second(2, 2, CV_8UC1, cv::Scalar(2));
  KeptPictures kept({"a"});
  kept.Put("a", first);
  kept.Put("a", second);
  EXPECT_EQ(kept.Find("a")->data, first.data);
}

}  // namespace
}  // namespace dorsum
