// SPDX-License-Identifier: Apache-2.0
#include "report/photo_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "report/drawing.h"

namespace dorsum {
namespace {

const Colour kTint{190, 150, 40};
const Colour kOutline{40, 170, 255};
const Colour kNoOrder{150, 150, 150};

cv::Mat BrightestChannel(const cv::Mat& photo) {
  if (photo.channels() == 1) return photo.clone();
  std::vector<cv::Mat> channels;
  cv::split(photo, channels);
  cv::Mat grey = channels[0];
  for (std::size_t i = 1; i < std::min<std::size_t>(channels.size(), 3); ++i)
    cv::max(grey, channels[i], grey);
  return grey;
}

// Grey value below which a share of the pixels lies.
int Percentile(const cv::Mat1b& grey, double share) {
  std::array<std::int64_t, 256> counts{};
  for (const unsigned char value : grey) ++counts[value];
  const auto wanted = static_cast<std::int64_t>(share * static_cast<double>(grey.total()));
  std::int64_t seen = 0;
  for (int value = 0; value < 256; ++value) {
    seen += counts[static_cast<std::size_t>(value)];
    if (seen > wanted) return value;
  }
  return 255;
}

cv::Mat Scaled(const cv::Mat& picture, int width, int interpolation) {
  if (picture.empty()) return {};
  const double scale = double(width) / picture.cols;
  cv::Mat out;
  cv::resize(picture, out, {width, std::max(1, static_cast<int>(std::lround(scale * picture.rows)))}, 0.0,
             0.0, interpolation);
  return out;
}

cv::Mat Backdrop(const cv::Mat& photo, int width) {
  return Scaled(BrightenPhoto(photo), width, photo.cols > width ? cv::INTER_AREA : cv::INTER_LINEAR);
}

// A canvas for stripes whose photo is missing.
cv::Mat EmptyPhoto(const LaserStripes& stripes) {
  float width = 64.0F, height = 48.0F;
  for (const StripePoint& p : stripes.points) {
    width = std::max(width, p.u + 20.0F);
    height = std::max(height, p.v + 20.0F);
  }
  return cv::Mat::zeros(std::min(8192, int(height)), std::min(8192, int(width)), CV_8UC3);
}

class StripePainter {
 public:
  StripePainter(cv::Mat canvas, double scale, double text_px)
      : canvas_(std::move(canvas)), scale_(scale), text_px_(text_px) {}

  void DrawSegment(const LaserStripes& stripes, const StripeSegment& segment) {
    std::vector<cv::Point> line;
    constexpr int kBits = 4;
    for (std::int32_t i = 0; i < segment.count; ++i) {
      const cv::Point2d p = At(stripes, segment, i);
      line.emplace_back(static_cast<int>(std::lround(16.0 * p.x)), static_cast<int>(std::lround(16.0 * p.y)));
    }
    const int thickness = segment.order == 0 ? 4 : 2;
    cv::polylines(canvas_, line, false, Pen(ColourOf(segment)), thickness, cv::LINE_AA, kBits);
  }

  // Numbers of long segments come first; one that would cover another is moved along its stripe or left out.
  void DrawNumber(const LaserStripes& stripes, const StripeSegment& segment) {
    if (!segment.order || segment.count * scale_ < 2.5 * text_px_) return;
    const TextStyle style{
        .size_px = text_px_, .colour = ColourOf(segment), .align = Align::kCentre, .bold = true};
    const std::string text = std::to_string(*segment.order);
    const cv::Size size = MeasureText(text, style);
    for (const double along : {0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9}) {
      const cv::Point2d p = At(stripes, segment, static_cast<std::int32_t>(along * (segment.count - 1)));
      const cv::Rect2d box(p.x - 0.5 * size.width - 4.0, p.y - 0.5 * size.height - 4.0, size.width + 8.0,
                           size.height + 8.0);
      const cv::Rect2d inside = box & cv::Rect2d(0.0, 0.0, canvas_.cols, canvas_.rows);
      const bool is_free = std::none_of(taken_.begin(), taken_.end(),
                                        [&](const cv::Rect2d& other) { return (other & box).area() > 0.0; });
      if (inside.area() < box.area() || !is_free) continue;
      taken_.push_back(box);
      const cv::Rect plate(static_cast<int>(box.x) + 1, static_cast<int>(box.y),
                           static_cast<int>(box.width) - 2, static_cast<int>(box.height));
      canvas_(plate).convertTo(canvas_(plate), -1, 0.12);  // a minus would run into its own stripe
      DrawText(canvas_, text, {p.x, p.y + 0.5 * size.height}, style);
      return;
    }
  }

 private:
  static Colour ColourOf(const StripeSegment& segment) {
    return segment.order ? OrderColour(*segment.order) : kNoOrder;
  }
  cv::Point2d At(const LaserStripes& stripes, const StripeSegment& segment, std::int32_t i) const {
    const StripePoint& p =
        stripes.points.at(static_cast<std::size_t>(segment.first) + static_cast<std::size_t>(i));
    return {scale_ * (p.u + 0.5) - 0.5, scale_ * (p.v + 0.5) - 0.5};
  }

  cv::Mat canvas_;
  double scale_, text_px_;
  std::vector<cv::Rect2d> taken_;
};

}  // namespace

cv::Mat BrightenPhoto(const cv::Mat& photo) {
  if (photo.empty()) return {};
  cv::Mat grey = BrightestChannel(photo);
  const int low = Percentile(grey, 0.005), high = std::max(Percentile(grey, 0.995), low + 16);
  cv::Mat1b table(1, 256);
  for (int value = 0; value < 256; ++value) {
    const double t = std::clamp(double(value - low) / (high - low), 0.0, 1.0);
    table(value) = cv::saturate_cast<unsigned char>(255.0 * std::pow(t, 0.8));
  }
  cv::Mat out;
  cv::LUT(grey, table, grey);
  cv::cvtColor(grey, out, cv::COLOR_GRAY2BGR);
  return out;
}

cv::Mat DrawMask(const cv::Mat& photo, const cv::Mat& mask, const PhotoPictureOptions& options) {
  if (!mask.empty() && !photo.empty() && mask.size() != photo.size()) {
    throw std::logic_error("DrawMask: the mask has another size than the photo");
  }
  const cv::Mat base = photo.empty() ? cv::Mat(mask.size(), CV_8UC3, cv::Scalar::all(90)) : photo;
  cv::Mat canvas = Backdrop(base, options.width_px);
  if (mask.empty() || canvas.empty()) return canvas;
  cv::Mat small = Scaled(mask, options.width_px, cv::INTER_LINEAR);
  cv::threshold(small, small, 127, 255, cv::THRESH_BINARY);
  canvas.forEach<Colour>([&](Colour& pixel, const int* at) {
    const bool inside = small.at<unsigned char>(at[0], at[1]) != 0;
    pixel = inside ? Mix(Mix(pixel, {255, 255, 255}, 0.12), kTint, 0.35) : Mix(pixel, {0, 0, 0}, 0.35);
  });
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(small, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  cv::polylines(canvas, outlines, true, Pen(kOutline), 2, cv::LINE_AA);
  return canvas;
}

cv::Mat DrawIndexedStripes(const cv::Mat& photo, const LaserStripes& stripes,
                           const PhotoPictureOptions& options) {
  const cv::Mat base = photo.empty() ? EmptyPhoto(stripes) : photo;
  cv::Mat canvas = Backdrop(base, options.width_px);
  canvas.convertTo(canvas, -1, 0.3);
  StripePainter painter(canvas, double(options.width_px) / base.cols, options.text_px);
  for (const StripeSegment& segment : stripes.segments) painter.DrawSegment(stripes, segment);
  std::vector<std::size_t> by_length(stripes.segments.size());
  std::iota(by_length.begin(), by_length.end(), std::size_t{0});
  std::stable_sort(by_length.begin(), by_length.end(), [&](std::size_t a, std::size_t b) {
    return stripes.segments[a].count > stripes.segments[b].count;
  });
  for (const std::size_t i : by_length) painter.DrawNumber(stripes, stripes.segments[i]);
  return canvas;
}

}  // namespace dorsum
