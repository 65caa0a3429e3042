// SPDX-License-Identifier: Apache-2.0
#include "report/board_pictures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Core>
#include <opencv2/imgproc.hpp>

#include "report/drawing.h"
#include "report/photo_pictures.h"

namespace dorsum {
namespace {

// The best rotation and shift of `grid` onto `seen` in the plane, and what remains of it, squared.
double AlignGrid(const std::vector<Eigen::Vector2d>& seen, std::vector<Eigen::Vector2d>* grid) {
  Eigen::Vector2d seen_mean = Eigen::Vector2d::Zero(), grid_mean = seen_mean;
  const auto count = static_cast<double>(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen_mean += seen[i] / count;
    grid_mean += (*grid)[i] / count;
  }
  double along = 0.0, across = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Eigen::Vector2d s = seen[i] - seen_mean, g = (*grid)[i] - grid_mean;
    along += g.dot(s);
    across += g.x() * s.y() - g.y() * s.x();
  }
  const double angle = std::atan2(across, along);
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  double remains = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    (*grid)[i] = turn * ((*grid)[i] - grid_mean) + seen_mean;
    remains += ((*grid)[i] - seen[i]).squaredNorm();
  }
  return remains;
}

double Rms(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).dot(a[i] - b[i]);
  return a.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(a.size()));
}

// 1, 2 or 5 times a power of ten, so that typical arrows become about 18 px long.
double Enlargement(double rms_px) {
  const double wanted = std::clamp(18.0 / std::max(rms_px, 1e-3), 1.0, 5000.0);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  return power * (wanted >= 5.0 * power ? 5.0 : wanted >= 2.0 * power ? 2.0 : 1.0);
}

void DrawNote(cv::Mat& canvas, const std::string& text) {
  const TextStyle style{.size_px = 15.0, .colour = {255, 255, 255}};
  const cv::Size size = MeasureText(text, style);
  const cv::Rect plate = cv::Rect(10, canvas.rows - size.height - 34, size.width + 28, size.height + 24) &
                         cv::Rect({}, canvas.size());
  if (plate.empty()) return;
  canvas(plate).convertTo(canvas(plate), -1, 0.25);
  DrawText(canvas, text, {plate.x + 14.0, canvas.rows - 22.0}, style);
}

}  // namespace

std::vector<cv::Point2f> ReprojectBoard(const Camera& camera, const std::vector<cv::Point2f>& corners,
                                        cv::Size inner, double square_mm) {
  if (corners.empty() || static_cast<int>(corners.size()) != inner.area() || !(square_mm > 0.0)) return {};
  std::vector<Eigen::Vector2d> seen, grid, mirrored;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Ray ray = CastRay(camera, {corners[i].x, corners[i].y});
    const std::optional<double> distance = Intersect(ray, Plane{});
    if (!distance) return {};
    seen.emplace_back(ray.At(*distance).head<2>());
    const int column = static_cast<int>(i) % inner.width, row = static_cast<int>(i) / inner.width;
    grid.emplace_back(column * square_mm, -row * square_mm);
    mirrored.emplace_back(column * square_mm, row * square_mm);
  }
  // Corners may be counted clockwise or counter-clockwise.
  const bool is_mirrored = AlignGrid(seen, &mirrored) < AlignGrid(seen, &grid);
  std::vector<cv::Point2f> expected;
  for (const Eigen::Vector2d& p : is_mirrored ? mirrored : grid) {
    const Eigen::Vector2d pixel = Project(camera, {p.x(), p.y(), 0.0});
    expected.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  }
  return expected;
}

cv::Mat DrawReprojection(const cv::Mat& photo, const std::vector<cv::Point2f>& seen,
                         const std::vector<cv::Point2f>& expected, int width_px) {
  if (photo.empty()) return {};
  cv::Mat canvas;
  const double scale = double(width_px) / photo.cols;
  cv::resize(BrightenPhoto(photo), canvas, {}, scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  canvas.convertTo(canvas, -1, 0.6);
  const bool has_arrows = expected.size() == seen.size() && !seen.empty();
  const double rms = has_arrows ? Rms(seen, expected) : 0.0, longer = Enlargement(rms);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const cv::Point2d at = scale * cv::Point2d(seen[i]);
    if (has_arrows) {
      DrawLine(canvas, at, at + longer * scale * cv::Point2d(expected[i] - seen[i]), {40, 200, 255}, 2);
    }
    cv::circle(canvas, at, 5, Pen({90, 235, 120}), 2, cv::LINE_AA);
  }
  if (has_arrows) {
    DrawNote(canvas, "errors drawn " + FormatNumber(longer, 0) + " times longer; rms " +
                         FormatNumber(rms, 3) + " px");
  }
  return canvas;
}

cv::Mat DrawCornerCoverage(cv::Size image, const std::vector<std::vector<cv::Point2f>>& views, int width_px) {
  if (image.empty()) return {};
  const double scale = double(width_px) / image.width;
  cv::Mat canvas(std::max(1, static_cast<int>(scale * image.height)), width_px, CV_8UC3, Pen({38, 34, 32}));
  for (std::size_t view = 0; view < views.size(); ++view) {
    const double share = views.size() > 1 ? double(view) / double(views.size() - 1) : 0.5;
    for (const cv::Point2f& corner : views[view]) {
      const cv::Point2d at = scale * cv::Point2d(corner);
      cv::circle(canvas, at, 4, Pen(SequentialColour(0.25 + 0.75 * share)), cv::FILLED, cv::LINE_AA);
    }
  }
  return canvas;
}

}  // namespace dorsum
