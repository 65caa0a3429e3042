// SPDX-License-Identifier: Apache-2.0
#include "report/design_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

#include <opencv2/imgproc.hpp>

#include "report/drawing.h"
#include "report/plot.h"

namespace dorsum {
namespace {

const Colour kNight{30, 24, 20};
const Colour kDim{120, 112, 104};
const Colour kLight{226, 222, 218};

// Colours of lines on paper that differ in lightness as well as in hue.
Colour LineColour(std::size_t i, std::size_t count) {
  return SequentialColour(count < 2 ? 0.35 : 0.85 * static_cast<double>(i) / static_cast<double>(count - 1));
}

Eigen::Vector3d OnPlane(const Camera& camera, const Eigen::Vector2d& pixel, double z) {
  const Ray ray = CastRay(camera, pixel);
  return ray.At((z - ray.origin.z()) / std::min(-1e-9, ray.direction.z()));
}

// Same scale along both axes.
PlotArea SideArea(cv::Size size, double left, double right, double top) {
  PlotArea area{{84, 24, size.width - 84 - 30, size.height - 24 - 66}, {left, right}, {-20.0, top}};
  const double scale = std::max(area.x.Span() / area.pixels.width, area.y.Span() / area.pixels.height);
  const double middle = 0.5 * (left + right);
  area.x = {middle - 0.5 * scale * area.pixels.width, middle + 0.5 * scale * area.pixels.width};
  area.y.high = area.y.low + scale * area.pixels.height;
  return area;
}

void DrawDashed(cv::Mat& canvas, cv::Point2d a, cv::Point2d b, const Colour& colour) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  constexpr double kDash = 9.0;
  for (double from = 0.0; from < length; from += 2.0 * kDash) {
    const double to = std::min(length, from + kDash);
    DrawLine(canvas, a + (b - a) * (from / length), a + (b - a) * (to / length), colour);
  }
}

void DrawBox(cv::Mat& canvas, const std::array<cv::Point2d, 4>& corners, const Colour& colour) {
  for (std::size_t i = 0; i < 4; ++i) DrawDashed(canvas, corners[i], corners[(i + 1) % 4], colour);
}

}  // namespace

cv::Mat DrawDesignFromTheSide(const DesignDrawing& drawing, cv::Size size) {
  cv::Mat canvas(size, CV_8UC3, Pen(kNight));
  const Camera& camera = drawing.camera;
  const Eigen::Vector3d eye = camera.Center();
  const double middle_v = 0.5 * (camera.height - 1);
  const Eigen::Vector3d left = OnPlane(camera, {0.0, middle_v}, 0.0);
  const Eigen::Vector3d right = OnPlane(camera, {camera.width - 1.0, middle_v}, 0.0);
  const double low_x = std::min({left.x(), eye.x(), drawing.hand.min().x()});
  const double high_x = std::max({right.x(), eye.x(), drawing.hand.max().x()});
  double top = eye.z();
  for (const Eigen::Vector3d& grating : drawing.gratings) top = std::max(top, grating.z());
  const PlotArea area = SideArea(size, low_x - 25.0, high_x + 25.0, top + 30.0);
  const auto at = [&area](const Eigen::Vector3d& p) { return area.ToPixel(p.x(), p.z()); };

  // Sheets where the fan is at its middle: their points nearest to y of the grating. From the back to the
  // front, so that the first laser's stand out.
  for (auto stripe = drawing.stripes.rbegin(); stripe != drawing.stripes.rend(); ++stripe) {
    if (stripe->points.empty()) continue;
    const Eigen::Vector3d grating = drawing.gratings.at(static_cast<std::size_t>(stripe->laser));
    const auto nearest =
        std::min_element(stripe->points.begin(), stripe->points.end(), [&](const auto& a, const auto& b) {
          return std::abs(a.y() - grating.y()) < std::abs(b.y() - grating.y());
        });
    if (nearest->x() < area.x.low || nearest->x() > area.x.high) continue;
    const Colour colour = Mix(OrderColour(stripe->order), kNight, stripe->laser == 0 ? 0.15 : 0.72);
    DrawLine(canvas, at(grating), at(*nearest), colour, stripe->laser == 0 && stripe->order == 0 ? 2 : 1);
  }
  DrawLine(canvas, at({area.x.low, 0.0, 0.0}), at({area.x.high, 0.0, 0.0}), kLight, 2);
  const auto& hand = drawing.hand;
  DrawBox(canvas,
          {at({hand.min().x(), 0.0, drawing.low_mm}), at({hand.max().x(), 0.0, drawing.low_mm}),
           at({hand.max().x(), 0.0, drawing.high_mm}), at({hand.min().x(), 0.0, drawing.high_mm})},
          kLight);
  DrawText(canvas, "working volume over the hand area",
           at({hand.min().x(), 0.0, drawing.high_mm}) + cv::Point2d(4, -7),
           {.size_px = 11.0, .colour = kLight});
  DrawLine(canvas, at(eye), at(left), kDim);
  DrawLine(canvas, at(eye), at(right), kDim);
  cv::circle(canvas, at(eye), 8, Pen(kLight), cv::FILLED, cv::LINE_AA);
  DrawText(canvas, "camera", at(eye) + cv::Point2d(0, -15),
           {.size_px = 12.0, .colour = kLight, .align = Align::kCentre});
  for (std::size_t k = 0; k < drawing.gratings.size(); ++k) {
    const cv::Point2d p = at(drawing.gratings[k]);
    cv::rectangle(canvas, p - cv::Point2d(4, 4), p + cv::Point2d(4, 4), Pen(OrderColour(0)), cv::FILLED);
    DrawText(canvas, std::to_string(k), p + cv::Point2d(0, -10),
             {.size_px = 11.0, .colour = kLight, .align = Align::kCentre});
  }
  // Numbers on paper beside the night.
  cv::Mat sheet(size, CV_8UC3, Pen(kPaper));
  canvas(area.pixels).copyTo(sheet(area.pixels));
  DrawAxes(sheet, area, "x across the stripes (mm)", "z above the backplane (mm)");
  return sheet;
}

cv::Mat DrawDesignAsSeen(const DesignDrawing& drawing, int width) {
  const Camera& camera = drawing.camera;
  const double scale = static_cast<double>(width) / camera.width;
  const int height = std::max(1, static_cast<int>(std::lround(scale * camera.height)));
  cv::Mat canvas(height, width, CV_8UC3, Pen(kNight));
  const auto at = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2d pixel = Project(camera, p);
    return cv::Point2d(scale * (pixel.x() + 0.5) - 0.5, scale * (pixel.y() + 0.5) - 0.5);
  };
  const cv::Rect2d picture(-50.0, -50.0, width + 100.0, height + 100.0);
  for (const DesignDrawing::Stripe& stripe : drawing.stripes | std::views::reverse) {
    const bool first = stripe.laser == 0;
    const Colour colour = Mix(OrderColour(stripe.order), kNight, first ? 0.0 : 0.7);
    for (std::size_t i = 1; i < stripe.points.size(); ++i) {
      // Points far outside would come back through the lens' distortion.
      const cv::Point2d a = at(stripe.points[i - 1]), b = at(stripe.points[i]);
      if (picture.contains(a) && picture.contains(b)) DrawLine(canvas, a, b, colour, first ? 3 : 2);
    }
  }
  const auto& hand = drawing.hand;
  for (const double z : {drawing.low_mm, drawing.high_mm}) {
    const std::array<cv::Point2d, 4> corners = {
        at({hand.min().x(), hand.min().y(), z}), at({hand.max().x(), hand.min().y(), z}),
        at({hand.max().x(), hand.max().y(), z}), at({hand.min().x(), hand.max().y(), z})};
    DrawBox(canvas, corners, kLight);
    const bool top = z == drawing.high_mm;  // so that neither name lies on the other's frame
    DrawText(canvas, FormatNumber(z, 0) + " mm",
             corners[top ? 3 : 1] + cv::Point2d(top ? 8 : -8, top ? 22 : -8),
             {.size_px = 12.0, .colour = kLight, .align = top ? Align::kLeft : Align::kRight});
  }
  return canvas;
}

cv::Mat DrawDesignCurves(const std::vector<DesignCurve>& curves, const std::string& x_name,
                         const std::string& y_name, cv::Size size) {
  cv::Mat canvas(size, CV_8UC3, Pen(kPaper));
  Range x{1e300, -1e300}, y{0.0, -1e300};
  for (const DesignCurve& curve : curves) {
    for (const Eigen::Vector2d& p : curve.points) {
      if (!p.allFinite()) continue;
      x = {std::min(x.low, p.x()), std::max(x.high, p.x())};
      y.high = std::max(y.high, p.y());
    }
  }
  const PlotArea area{{84, 20, size.width - 84 - 160, size.height - 20 - 66}, RoundOut(x, 12), RoundOut(y)};
  DrawGrid(canvas, area);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Colour colour = LineColour(i, curves.size());
    const auto& points = curves[i].points;
    for (std::size_t j = 1; j < points.size(); ++j) {
      if (!points[j - 1].allFinite() || !points[j].allFinite()) continue;
      DrawLine(canvas, area.ToPixel(points[j - 1].x(), points[j - 1].y()),
               area.ToPixel(points[j].x(), points[j].y()), colour, 2);
    }
    const double row = area.pixels.y + 16.0 + 24.0 * static_cast<double>(i);
    DrawLine(canvas, {area.pixels.br().x + 16.0, row}, {area.pixels.br().x + 42.0, row}, colour, 3);
    DrawText(canvas, curves[i].name, {area.pixels.br().x + 50.0, row + 5.0}, {.size_px = 11.0});
  }
  DrawAxes(canvas, area, x_name, y_name);
  return canvas;
}

}  // namespace dorsum
