// SPDX-License-Identifier: Apache-2.0
#include "imaging/unchanged_part.h"

#include <opencv2/imgproc.hpp>

#include "captures/green_channel.h"

namespace dorsum {
namespace {

constexpr int kSquare = 4;  // px

cv::Mat Shrink(const cv::Mat& bgr) {
  const cv::Mat green = GreenChannel(bgr);
  const cv::Size squares(green.cols / kSquare, green.rows / kSquare);
  cv::Mat out(squares, CV_8UC1);
  if (!squares.empty()) {
    const cv::Rect whole(0, 0, squares.width * kSquare, squares.height * kSquare);
    cv::resize(green(whole), out, squares, 0, 0, cv::INTER_AREA);
  }
  return out;
}

}  // namespace

UnchangedPart::UnchangedPart(const cv::Mat& background, const cv::Mat& hand)
    : size_(hand.size()), before_(Shrink(background)) {
  cv::absdiff(before_, Shrink(hand), difference_);
}

cv::Mat UnchangedPart::Mask(double share) const {
  cv::Mat mask(size_, CV_8UC1, cv::Scalar(0)), allowed;
  if (before_.empty()) return mask;
  before_.convertTo(allowed, CV_8U, share, 1.0);
  const cv::Mat small = difference_ <= allowed;
  const cv::Rect whole(0, 0, small.cols * kSquare, small.rows * kSquare);
  cv::resize(small, mask(whole), whole.size(), 0, 0, cv::INTER_NEAREST);
  return mask;
}

}  // namespace dorsum
