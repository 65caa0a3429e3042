// SPDX-License-Identifier: Apache-2.0
#include "jobs/measure_stripes.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "stripes/append_segment.h"
#include "stripes/pooling.h"
#include "stripes/shading.h"

namespace dorsum {

void KeepInside(const cv::Mat& mask, IndexedStripes* stripes) {
  const cv::Rect picture({}, mask.size());
  for (LaserStripes& one : stripes->lasers) {
    std::vector<char> keep;
    for (const StripePoint& p : one.points) {
      const cv::Point at(cvRound(p.u), cvRound(p.v));
      keep.push_back(picture.contains(at) && mask.at<std::uint8_t>(at) != 0 ? 1 : 0);
    }
    one = KeepPoints(one, keep);
  }
}

void MeasureStripes(const cv::Mat& green_hand, const cv::Mat& mask,
                    const std::map<int, LaserPicture>& pictures, const ReconstructOptions& options,
                    const Context& context, IndexedStripes* stripes) {
  PoolingOptions pooling = options.pooling;
  if (options.shading == "led") {
    std::vector<LaserPicture> own;
    own.reserve(stripes->lasers.size());
    for (const LaserStripes& one : stripes->lasers) own.push_back(pictures.at(one.laser));
    const SurfaceBrightness brightness(green_hand, mask, *stripes, options.surface_shading.brightness,
                                       context);
    FitOnShadedSurface(brightness, own, options.ridge.fit, options.surface_shading, context, stripes);
    pooling.pull.across_share *= options.surface_shading.left_over;
  }
  ParallelFor(context, 0, static_cast<std::int64_t>(stripes->lasers.size()), [&](std::int64_t i) {
    LaserStripes& one = stripes->lasers[static_cast<std::size_t>(i)];
    one = PoolAlongStripes(std::move(one), pooling, context);
  });
}

}  // namespace dorsum
