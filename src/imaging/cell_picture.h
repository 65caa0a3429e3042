// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>

namespace dorsum {

// A picture of what changes slowly: kept in the middle of squares, and linear between. Beyond the outer
// ones' middles it is constant.
class CellPicture {
 public:
  CellPicture() = default;
  // `cells` is CV_32FC1, one number for each square of `side` px.
  CellPicture(cv::Mat cells, int side) : cells_(std::move(cells)), side_(side) {}

  // The part that begins at `corner`, `times` as large, its values multiplied by `factor`.
  CellPicture Part(cv::Point corner, int times, float factor) const {
    CellPicture part = *this;
    part.corner_ += corner / times_;
    part.times_ *= times;
    part.factor_ *= factor;
    return part;
  }

  float At(int u, int v) const {
    const Place x(u / times_ + corner_.x, side_, cells_.cols), y(v / times_ + corner_.y, side_, cells_.rows);
    const auto *upper = cells_.ptr<float>(y.before), *lower = cells_.ptr<float>(y.after);
    const float above = upper[x.before] * (1.0F - x.share) + upper[x.after] * x.share;
    const float below = lower[x.before] * (1.0F - x.share) + lower[x.after] * x.share;
    return (above * (1.0F - y.share) + below * y.share) * factor_;
  }

 private:
  struct Place {  // between two cells of a row or column
    Place(int at, int side, int cells) {
      const float place = (static_cast<float>(at) + 0.5F) / static_cast<float>(side) - 0.5F;
      const float within = std::clamp(place, 0.0F, static_cast<float>(cells - 1));
      before = static_cast<int>(within);
      after = std::min(before + 1, cells - 1);
      share = within - static_cast<float>(before);
    }
    int before, after;
    float share;
  };

  cv::Mat cells_;
  int side_ = 1, times_ = 1;
  cv::Point corner_;  // px of the picture that the cells make
  float factor_ = 1.0F;
};

}  // namespace dorsum
