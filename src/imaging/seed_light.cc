// SPDX-License-Identifier: Apache-2.0
#include "imaging/seed_light.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "imaging/seed_map.h"
#include "imaging/sharp_step.h"

namespace dorsum {
namespace {

constexpr int kEvery = 2;        // px between those whose texture counts
constexpr int kCell = 8;         // px: statistics are kept for squares of this side
constexpr double kReach = 2.0;   // cells: one standard deviation of the distance over which they count
constexpr double kTrust = 20.0;  // px: known pixels nearby that weigh as much as all of the image

// Number, mean and mean square of a quantity over the pixels of a mask, in squares around each square.
struct LocalMoments {
  cv::Mat mean, square;
};

LocalMoments MomentsNear(const cv::Mat& values, const cv::Mat& mask) {
  const cv::Size cells((values.cols + kCell - 1) / kCell, (values.rows + kCell - 1) / kCell);
  cv::Mat n = cv::Mat::zeros(cells, CV_32F), sum = n.clone(), squares = n.clone();
  for (int v = 0; v < values.rows; ++v) {
    const auto* value = values.ptr<float>(v);
    const auto* use = mask.ptr<std::uint8_t>(v);
    for (int u = 0; u < values.cols; ++u) {
      if (use[u] == 0) continue;
      n.at<float>(v / kCell, u / kCell) += 1.0F;
      sum.at<float>(v / kCell, u / kCell) += value[u];
      squares.at<float>(v / kCell, u / kCell) += value[u] * value[u];
    }
  }
  const double count = cv::sum(n)[0];
  const double mean = count > 0.0 ? cv::sum(sum)[0] / count : 1.0;
  const double square = count > 0.0 ? cv::sum(squares)[0] / count : 1.0;
  for (cv::Mat* m : {&n, &sum, &squares}) cv::GaussianBlur(*m, *m, {}, kReach, kReach, cv::BORDER_CONSTANT);
  n += kTrust / (kCell * kCell);
  sum += mean * kTrust / (kCell * kCell);
  squares += square * kTrust / (kCell * kCell);
  return {sum / n, squares / n};
}

// Pixels of a kind away from the outline, whose blur and own shade are not theirs.
cv::Mat Inner(const cv::Mat& known, std::uint8_t kind) {
  cv::Mat inner = known == kind;
  cv::erode(inner, inner, cv::getStructuringElement(cv::MORPH_RECT, {3, 5}));
  return inner;
}

void Enlarge(cv::Mat* cells, cv::Size size) {
  // The cells' raster may reach beyond the image.
  cv::Mat large;
  cv::resize(*cells, large, {cells->cols * kCell, cells->rows * kCell}, 0, 0, cv::INTER_LINEAR);
  *cells = large(cv::Rect({0, 0}, size)).clone();
}

}  // namespace

cv::Mat UsualTexture(const cv::Mat& light, const cv::Mat& known) {
  constexpr double kLeast = 0.002;
  const cv::Mat inner = Inner(known, kObjectPixel) | Inner(known, kBackplanePixel);
  cv::Mat steps = cv::Mat::zeros(light.size(), CV_32FC1), use = cv::Mat::zeros(light.size(), CV_8UC1);
  for (int v = 0; v + 1 < light.rows; v += kEvery) {
    const auto* known_there = inner.ptr<std::uint8_t>(v);
    for (int u = 0; u + 1 < light.cols; u += kEvery) {
      if (known_there[u] == 0) continue;
      use.at<std::uint8_t>(v, u) = 255;
      const float across = SharpStep(light, {u, v}, {1, 0}), down = SharpStep(light, {u, v}, {0, 1});
      steps.at<float>(v, u) = std::sqrt(across * across + down * down);
    }
  }
  LocalMoments near = MomentsNear(steps, use);
  cv::Mat texture;
  cv::sqrt(near.square * 0.5, texture);
  texture = cv::max(texture, kLeast);
  Enlarge(&texture, light.size());
  return texture;
}

cv::Mat LikeObject(const cv::Mat& light, const cv::Mat& known) {
  constexpr float kSpread = 0.03F;  // least standard deviation of either kind's light
  constexpr float kNeither = 0.5F;  // density of light that tells nothing
  constexpr float kStrange = 0.3F;  // what light unlike both says for the object: shadow has no sharp edge
  LocalMoments object = MomentsNear(light, Inner(known, kObjectPixel));
  LocalMoments backplane = MomentsNear(light, Inner(known, kBackplanePixel));
  for (cv::Mat* m : {&object.mean, &object.square, &backplane.mean, &backplane.square})
    Enlarge(m, light.size());
  cv::Mat out(light.size(), CV_32FC1);
  for (int v = 0; v < light.rows; ++v) {
    for (int u = 0; u < light.cols; ++u) {
      if (known.at<std::uint8_t>(v, u) != kUnknownPixel) {
        out.at<float>(v, u) = 0.0F;
        continue;
      }
      const auto density = [&](const LocalMoments& moments) {
        const float mean = moments.mean.at<float>(v, u);
        const float variance =
            std::max(0.0F, moments.square.at<float>(v, u) - mean * mean) + kSpread * kSpread;
        const float off = light.at<float>(v, u) - mean;
        return std::exp(-0.5F * off * off / variance) / std::sqrt(variance);
      };
      const float as_object = density(object), as_backplane = density(backplane);
      out.at<float>(v, u) =
          (as_object - as_backplane + kStrange * kNeither) / (as_object + as_backplane + kNeither);
    }
  }
  return out;
}

}  // namespace dorsum
