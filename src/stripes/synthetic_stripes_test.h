// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Dense>
#include <opencv2/core.hpp>

#include "base/random.h"
#include "stripes/stripes.h"

namespace dorsum {

// Many simultaneous stripes on a surface with two humps and uneven reflectance; no optics, no speckle, so
// that the Cramér-Rao bound can be told exactly. For tests and for the accuracy bench.
struct SyntheticStripeDesign {
  int width = 1600, height = 1200;  // px
  int stripes = 40;
  double sigma_px = 2.0;  // of the profile
  double peak = 200.0;    // of a stripe on a white surface, grey values; the image clips at 255
  double background = 4.0, noise_sd = 1.0;  // grey values
  double min_reflectance = 0.1, max_reflectance = 1.0;
  double hump_px = 12.0;  // how far a hump shifts stripes
  std::uint64_t seed = 1;
};

struct SyntheticTruth {
  double u = 0.0, amplitude = 0.0;  // px, grey values (may exceed 255)
};

struct SyntheticStripes {
  SyntheticStripeDesign design;
  cv::Mat image;                                   // CV_8UC1
  std::vector<std::vector<SyntheticTruth>> truth;  // by row, by growing u
};

inline SyntheticStripes RenderSyntheticStripes(const SyntheticStripeDesign& d) {
  SyntheticStripes out{d, cv::Mat(d.height, d.width, CV_8UC1), {}};
  Rng rng(NamedSeed("synthetic stripes", d.seed));
  const double phase_a = rng.Uniform(0.0, 6.28), phase_b = rng.Uniform(0.0, 6.28);
  const auto hump = [&d](double u, double v, double at_u, double at_v) {
    const double x = (u - at_u * d.width) / (0.12 * d.width), y = (v - at_v * d.height) / (0.15 * d.height);
    return std::exp(-0.5 * (x * x + y * y));
  };
  const double spacing = static_cast<double>(d.width) / d.stripes;
  std::vector<double> light(static_cast<std::size_t>(d.width));
  for (int v = 0; v < d.height; ++v) {
    std::fill(light.begin(), light.end(), d.background);
    std::vector<SyntheticTruth> row;
    for (int k = 0; k < d.stripes; ++k) {
      const double straight = (k + 0.5) * spacing + 0.01 * (v - 0.5 * d.height);
      const double u = straight + d.hump_px * (hump(straight, v, 0.35, 0.4) - hump(straight, v, 0.7, 0.6));
      const double wave = std::sin(0.011 * u + phase_a) * std::sin(0.013 * v + phase_b);
      const double reflectance = 0.5 * (d.min_reflectance + d.max_reflectance) +
                                 0.5 * (d.max_reflectance - d.min_reflectance) * wave;
      const double amplitude = d.peak * reflectance;
      for (int x = std::max(0, static_cast<int>(u - 6 * d.sigma_px));
           x <= std::min(d.width - 1, static_cast<int>(u + 6 * d.sigma_px)); ++x) {
        const double t = (x - u) / d.sigma_px;
        light[static_cast<std::size_t>(x)] += amplitude * std::exp(-0.5 * t * t);
      }
      row.push_back({u, amplitude});
    }
    auto* pixels = out.image.ptr<std::uint8_t>(v);
    for (int x = 0; x < d.width; ++x) {
      const double grey = light[static_cast<std::size_t>(x)] + d.noise_sd * rng.Normal();
      pixels[x] = static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 255.0)));
    }
    out.truth.push_back(std::move(row));
  }
  return out;
}

// Least standard deviation, px, that an unbiased estimate of the centre can have when width, amplitude and
// background are unknown too: the Cramér-Rao bound for pixels of independent normal noise (with the variance
// 1/12 of rounding) within `reach_px` of the centre. Clipped pixels tell nothing.
inline double CentreBound(double u, double amplitude, double sigma_px, double background, double noise_sd,
                          double reach_px, double clip = 255.0) {
  Eigen::Matrix4d fisher = Eigen::Matrix4d::Zero();
  for (int x = static_cast<int>(std::ceil(u - reach_px)); x <= u + reach_px; ++x) {
    const double t = (x - u) / sigma_px, shape = std::exp(-0.5 * t * t);
    if (background + amplitude * shape >= clip) continue;
    const Eigen::Vector4d gradient(amplitude * shape * t / sigma_px, amplitude * shape * t * t / sigma_px,
                                   shape, 1.0);
    fisher += gradient * gradient.transpose() / (noise_sd * noise_sd + 1.0 / 12.0);
  }
  return std::sqrt(fisher.inverse()(0, 0));
}

struct SyntheticScore {
  double recall = 0.0;       // true stripe points with a point of their own within 3 px in their row
  double false_share = 0.0;  // points without a true one within 3 px
  double rmse_px = 0.0;      // of the matched ones
  double bound_px = 0.0;     // root mean square of CentreBound over the same points
  double sigma_ratio = 0.0;  // root mean square of error over the point's own sd_px
  double Efficiency() const { return rmse_px / bound_px; }
};

// Matches each true point to the nearest found one in its row that no nearer truth takes.
inline SyntheticScore ScoreSyntheticStripes(const SyntheticStripes& scene, const LaserStripes& found) {
  std::vector<std::vector<StripePoint>> rows(scene.truth.size());
  for (const StripePoint& p : found.points) rows[static_cast<std::size_t>(std::lround(p.v))].push_back(p);
  const SyntheticStripeDesign& d = scene.design;
  const double spacing = static_cast<double>(d.width) / d.stripes;
  double total = 0.0, matched = 0.0, strays = 0.0, error = 0.0, bound = 0.0, normal = 0.0;
  for (std::size_t v = 0; v < rows.size(); ++v) {
    for (const StripePoint& p : rows[v]) {
      const auto is_near = [&p](const SyntheticTruth& t) {
        return std::abs(static_cast<double>(p.u) - t.u) < 3.0;
      };
      if (std::none_of(scene.truth[v].begin(), scene.truth[v].end(), is_near)) strays += 1.0;
    }
    std::vector<char> taken(rows[v].size(), 0);
    for (const SyntheticTruth& t : scene.truth[v]) {
      if (t.u < 3.0 * d.sigma_px || t.u > d.width - 1.0 - 3.0 * d.sigma_px) continue;
      total += 1.0;
      std::size_t best = rows[v].size();
      double nearest = 3.0;
      for (std::size_t i = 0; i < rows[v].size(); ++i) {
        const double apart = std::abs(static_cast<double>(rows[v][i].u) - t.u);
        if (taken[i] == 0 && apart < nearest) {
          nearest = apart;
          best = i;
        }
      }
      if (best == rows[v].size()) continue;
      taken[best] = 1;
      matched += 1.0;
      const double limit = CentreBound(t.u, t.amplitude, d.sigma_px, d.background, d.noise_sd, 0.5 * spacing);
      error += nearest * nearest;
      bound += limit * limit;
      normal += std::pow(nearest / static_cast<double>(rows[v][best].sd_px), 2.0);
    }
  }
  SyntheticScore score;
  score.recall = matched / std::max(1.0, total);
  score.false_share = strays / std::max(1.0, static_cast<double>(found.points.size()));
  score.rmse_px = std::sqrt(error / std::max(1.0, matched));
  score.bound_px = std::sqrt(bound / std::max(1.0, matched));
  score.sigma_ratio = std::sqrt(normal / std::max(1.0, matched));
  return score;
}

}  // namespace dorsum
