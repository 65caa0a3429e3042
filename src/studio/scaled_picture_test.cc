// SPDX-License-Identifier: Apache-2.0
#include "studio/scaled_picture.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "studio/patience_test.h"

namespace dorsum {
namespace {

QImage Plain(int width, int height, QColor colour) {
  QImage image(width, height, QImage::Format_BGR888);
  image.fill(colour);
  return image;
}

TEST(ScaledPicture, ASmallOneIsThereAtOnce) {
  ScaledPicture picture;
  EXPECT_TRUE(picture.In({10, 10}).isNull());
  picture.Set(Plain(100, 80, Qt::red));
  EXPECT_EQ(picture.In({50, 40}).size(), QSize(50, 40));
  EXPECT_EQ(picture.In({50, 40}).pixelColor(20, 20), QColor(Qt::red));
  picture.Set(Plain(100, 80, Qt::blue));
  EXPECT_EQ(picture.In({50, 40}).pixelColor(20, 20), QColor(Qt::blue));
  EXPECT_TRUE(picture.In({0, 40}).width() == 50);
}

TEST(ScaledPicture, OfLargeOnesTheLastIsShownAndWhatWasThereStaysUntilThen) {
  ScaledPicture picture;
  QSignalSpy ready(&picture, &ScaledPicture::Ready);
  picture.Set(Plain(1600, 1200, Qt::red));
  EXPECT_TRUE(picture.In({400, 300}).isNull());
  ASSERT_TRUE(ready.wait(kPatience_ms));
  EXPECT_EQ(picture.In({400, 300}).pixelColor(9, 9), QColor(Qt::red));
  picture.Set(Plain(1600, 1200, Qt::green));
  EXPECT_EQ(picture.In({400, 300}).pixelColor(9, 9), QColor(Qt::red));
  picture.Set(Plain(1600, 1200, Qt::blue));  // while green is being scaled
  while (picture.In({400, 300}).pixelColor(9, 9) != QColor(Qt::blue)) ASSERT_TRUE(ready.wait(kPatience_ms));
  EXPECT_EQ(picture.In({200, 150}).size(), QSize(400, 300));
  ASSERT_TRUE(ready.wait(kPatience_ms));
  EXPECT_EQ(picture.In({200, 150}).size(), QSize(200, 150));
}

TEST(ScaledPicture, WhatIsClearedDoesNotComeBack) {
  ScaledPicture picture;
  QSignalSpy ready(&picture, &ScaledPicture::Ready);
  picture.Set(Plain(1600, 1200, Qt::red));
  picture.In({400, 300});
  picture.Clear();
  EXPECT_FALSE(ready.wait(200));
  EXPECT_TRUE(picture.In({400, 300}).isNull());
}

}  // namespace
}  // namespace dorsum
