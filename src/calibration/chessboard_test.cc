// SPDX-License-Identifier: Apache-2.0
#include "calibration/chessboard.h"

#include <gtest/gtest.h>

#include "calibration/board_view_test.h"

namespace dorsum {
namespace {

const cv::Size kImage(320, 240), kInner(7, 5);

cv::Mat Green(const cv::Mat& bgr) {
  cv::Mat green;
  cv::extractChannel(bgr, green, 1);
  return green;
}

// A board seen from the side, its rows turned by `degrees`.
cv::Matx33d Perspective(double degrees) {
  const double c = 2.0 * std::cos(degrees * CV_PI / 180.0), s = 2.0 * std::sin(degrees * CV_PI / 180.0);
  const cv::Matx33d side(1.0, 0.0, 160.0, 0.0, 1.0, 120.0, 0.0, 0.0, 1.0);
  const cv::Matx33d tilt(1.0, 0.0, 0.0, 0.0, 0.92, 0.0, 0.0004, 0.0006, 1.0);
  const cv::Matx33d turn(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
  return side * tilt * turn;
}

double LargestError(const std::vector<cv::Point2f>& found, const std::vector<cv::Point2d>& truth) {
  double largest = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    largest = std::max(largest, cv::norm(cv::Point2d(found[i]) - truth[i]));
  return largest;
}

std::vector<cv::Point2f> Find(const cv::Matx33d& image_from_board) {
  return FindChessboard(Green(DrawBoard(kImage, kInner, 10.0, image_from_board, 8)), kInner)
      .value_or(std::vector<cv::Point2f>());
}

TEST(Chessboard, CornersAreFoundToATenthOfAPixel) {
  for (const double degrees : {1.5, 8.0, -20.0}) {  // along the axes the samples would show
    const auto corners = Find(Perspective(degrees));
    ASSERT_EQ(corners.size(), 35U) << degrees;
    EXPECT_LT(LargestError(corners, TrueCorners(kInner, 10.0, Perspective(degrees))), 0.1) << degrees;
  }
}

TEST(Chessboard, ABoardUpsideDownBeginsAtTheSameImageCorner) {
  const auto upright = Find(Perspective(3.0));
  const auto turned = Find(Perspective(183.0));
  ASSERT_EQ(upright.size(), 35U);
  ASSERT_EQ(turned.size(), 35U);
  EXPECT_LT(upright[0].x, 160.0F);
  EXPECT_LT(upright[0].y, 120.0F);
  for (std::size_t i = 0; i < 35; ++i) EXPECT_LT(cv::norm(upright[i] - turned[i]), 10.0);
}

TEST(Chessboard, NoBoardAHiddenBoardAndOtherCountsAreNone) {
  EXPECT_FALSE(FindChessboard(cv::Mat(240, 320, CV_8UC1, cv::Scalar(120)), kInner).has_value());
  cv::Mat board = Green(DrawBoard(kImage, kInner, 10.0, Perspective(0.0)));
  EXPECT_FALSE(FindChessboard(board, cv::Size(8, 5)).has_value());
  board.colRange(0, 130).setTo(210);
  EXPECT_FALSE(FindChessboard(board, kInner).has_value());
}

TEST(Chessboard, BoardPointsLieAboutTheCentre) {
  const auto points = ChessboardPoints(cv::Size(3, 4), 10.0);
  ASSERT_EQ(points.size(), 12U);
  EXPECT_EQ(points[0], cv::Point3f(-10.0F, -15.0F, 0.0F));
  EXPECT_EQ(points[1], cv::Point3f(0.0F, -15.0F, 0.0F));
  EXPECT_EQ(points[11], cv::Point3f(10.0F, 15.0F, 0.0F));
}

}  // namespace
}  // namespace dorsum
