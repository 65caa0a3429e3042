// SPDX-License-Identifier: Apache-2.0
#include "imaging/stripe_mask.h"

#include <opencv2/imgproc.hpp>

#include "imaging/stage_sink.h"

namespace dorsum {

cv::Mat ExtractStripeMask(const cv::Mat& image, const cv::Mat& region, const StripeMaskOptions& options,
                          const std::string& sink_key, const Context& context) {
  // Equation 3.5; filter2D correlates, so a positive answer means "brighter on the left".
  const cv::Mat kernel = (cv::Mat_<float>(3, 3) << 1, 0, -1, 1, 0, -1, 1, 0, -1);
  cv::Mat edges, green, mask;
  cv::filter2D(image, edges, CV_8U, kernel, {-1, -1}, 0.0, cv::BORDER_REPLICATE);
  cv::extractChannel(edges, green, 1);
  Sink(context, sink_key + "/edges", green);
  // OpenCV throws for windows of even side.
  const int block = options.block_px | 1, median = options.median_px | 1;
  // A window with a negative constant: the pixel must exceed its neighbourhood's mean by the offset.
  cv::adaptiveThreshold(green, mask, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY, block,
                        -options.offset);
  if (median > 1) cv::medianBlur(mask, mask, median);
  if (!region.empty()) mask.setTo(0, region == 0);
  Sink(context, sink_key + "/mask", mask);
  return mask;
}

}  // namespace dorsum
