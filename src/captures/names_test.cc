// SPDX-License-Identifier: Apache-2.0
#include "captures/names.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(Names, AreTheDocumentsNames) {
  EXPECT_EQ(ChessName(0), "chess00");
  EXPECT_EQ(ChessName(11), "chess11");
  EXPECT_EQ(LaserBgName(Distance::kFurther), "laserCalFurtherBg");
  EXPECT_EQ(LaserCalName(3, Distance::kCloser), "laser3CalCloser");
  EXPECT_EQ(LaserChessName(0, Distance::kFurther), "laser0CalFurtherChess");
  EXPECT_EQ(StripesBgName(2), "stripesBg2");
  EXPECT_EQ(StripesHandName(7), "stripesHand7");
}

TEST(Names, HeightsAreRoundedNotCutOff) {
  EXPECT_EQ(HeightFolderName(13.5), "h13.5");
  EXPECT_EQ(HeightFolderName(27), "h27.0");
  EXPECT_EQ(HeightFolderName(8.3), "h8.3");  // 8.3 * 10 is a little less than 83
  EXPECT_EQ(HeightFolderName(0.05), "h0.1");
}

}  // namespace
}  // namespace dorsum
