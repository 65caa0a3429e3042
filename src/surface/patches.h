// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "surface/plate.h"

namespace dorsum {

// Square patches of the image that samples lie in; errors of different patches count as independent.
class Patches {
 public:
  Patches(const std::vector<PlateSample>& samples, double side_px) : scale_(1.0 / side_px) {
    for (const PlateSample& s : samples) {
      columns_ = std::max(columns_, Number(s.u) + 1);
      rows_ = std::max(rows_, Number(s.v) + 1);
    }
  }

  std::size_t size() const { return columns_ * rows_; }
  std::size_t At(const PlateSample& s) const { return Number(s.v) * columns_ + Number(s.u); }

 private:
  // Pixels' centres have whole coordinates, so -0.5 is still in the image.
  std::size_t Number(float px) const {
    return static_cast<std::size_t>(std::max(0.0, (static_cast<double>(px) + 1.0) * scale_));
  }

  double scale_;
  std::size_t columns_ = 0, rows_ = 0;
};

}  // namespace dorsum
