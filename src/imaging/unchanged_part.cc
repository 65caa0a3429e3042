// SPDX-License-Identifier: Apache-2.0
#include "imaging/unchanged_part.h"

#include <algorithm>
#include <cstdint>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
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

UnchangedPart::UnchangedPart(const cv::Mat& background, const cv::Mat& hand, const Context& context)
    : size_(hand.size()) {
  cv::Mat after;
  ParallelFor(context, 0, 2, [&](std::int64_t picture) {
    (picture == 0 ? before_ : after) = Shrink(picture == 0 ? background : hand);
  });
  cv::absdiff(before_, after, difference_);
}

cv::Mat UnchangedPart::Unchanged(double share) const {
  cv::Mat allowed;
  before_.convertTo(allowed, CV_8U, share, 1.0);
  return difference_ <= allowed;
}

double UnchangedPart::Share(double share) const {
  if (before_.empty()) return 0.0;
  return static_cast<double>(kSquare * kSquare * cv::countNonZero(Unchanged(share))) / size_.area();
}

cv::Mat UnchangedPart::Mask(double share, const Context& context) const {
  cv::Mat mask(size_, CV_8UC1, cv::Scalar(0));
  if (before_.empty()) return mask;
  const cv::Mat small = Unchanged(share);
  constexpr int kRowsTogether = 32;
  ParallelFor(context, 0, (small.rows + kRowsTogether - 1) / kRowsTogether, [&](std::int64_t block) {
    const int first = static_cast<int>(block) * kRowsTogether;
    const cv::Mat part = small.rowRange(first, std::min(small.rows, first + kRowsTogether));
    const cv::Rect whole(0, kSquare * first, kSquare * part.cols, kSquare * part.rows);
    cv::resize(part, mask(whole), whole.size(), 0, 0, cv::INTER_NEAREST);
  });
  return mask;
}

}  // namespace dorsum
