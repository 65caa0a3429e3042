// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "base/median.h"
#include "base/parallel.h"
#include "stripes/vector_exp.h"

namespace dorsum {
namespace {

// Variance of dark pixels from second differences along the rows, without the fifth that is largest, where
// stripes are.
double DarkVariance(const cv::Mat& green, const RowComb& rows) {
  // Neighbours often fall into one class, so each second one counts in a histogram of its own: none waits
  // for the other.
  std::array<std::array<int, 1021>, 2> histograms{};
  long count = 0;
  for (int row = rows.first; row < green.rows; row += rows.step) {
    const auto* g = green.ptr<std::uint8_t>(row);
    for (int u = 1; u + 1 < green.cols; ++u) {
      ++histograms[static_cast<std::size_t>(u) % 2]
                  [static_cast<std::size_t>(std::abs(g[u - 1] - 2 * g[u] + g[u + 1]))];
    }
    count += std::max(0, green.cols - 2);
  }
  const auto limit = static_cast<long>(0.8 * static_cast<double>(count));
  long kept = 0;
  double sum = 0.0;
  for (std::size_t d = 0; d < histograms[0].size() && kept < limit; ++d) {
    const long n = std::min<long>(histograms[0][d] + histograms[1][d], limit - kept);
    sum += static_cast<double>(d * d) * static_cast<double>(n);
    kept += n;
  }
  // The inner 80 % of a normal distribution hold 43.8 % of its variance; a second difference has six times
  // a pixel's.
  return kept > 0 ? sum / static_cast<double>(count) / 0.438 / 6.0 : 0.0;
}

struct RowFindings {
  std::vector<float> widths;
  std::vector<NoiseSample> samples;
  std::vector<StripePoint> points;
};

constexpr int kRowsTogether = 8;  // whose profiles are fitted together

// The rows first, first + step, … before `end`.
RowFindings SurveyRows(const cv::Mat& green, const std::vector<std::vector<RidgeCandidate>>& candidates,
                       int first, int end, int step, double width, const NoiseModel& noise,
                       const ProfileFitOptions& options) {
  std::vector<ProfileTask> tasks;
  std::vector<int> rows;
  for (int v = first; v < end; v += step) {
    const std::vector<RidgeCandidate>& row = candidates[static_cast<std::size_t>(v)];
    for (std::size_t i = 0; i < row.size(); ++i) {
      tasks.push_back({green.ptr<std::uint8_t>(v), StartBetween(row, i, width, green.cols)});
      rows.push_back(v);
    }
  }
  const std::vector<ProfileFit> fits = FitProfiles(tasks, noise, options);
  RowFindings out;
  std::vector<float> shapes;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    const ProfileFit& fit = fits[k];
    if (!fit.ok) continue;
    StripePoint point;
    point.u = static_cast<float>(fit.u);
    point.v = static_cast<float>(rows[k]);
    point.sd_px = static_cast<float>(fit.sd_u);
    out.points.push_back(point);
    if (fit.width_held) continue;
    out.widths.push_back(static_cast<float>(fit.width));
    const int n = fit.last - fit.first + 1 - fit.clipped;
    if (n < 8) continue;
    const auto freedom = static_cast<float>(n / (n - 4.0));
    const auto u = static_cast<float>(fit.u), narrowness = static_cast<float>(1.0 / fit.width);
    const auto background = static_cast<float>(fit.background), amplitude = static_cast<float>(fit.amplitude);
    shapes.clear();
    for (int x = fit.first; x <= fit.last; ++x) {
      const float t = (static_cast<float>(x) - u) * narrowness;
      shapes.push_back(-0.5F * t * t);
    }
    RaiseToExp(shapes);
    for (int x = fit.first; x <= fit.last; ++x) {
      const std::uint8_t grey = tasks[k].row[x];
      if (grey >= options.saturated_grey) continue;
      const float model = background + amplitude * shapes[static_cast<std::size_t>(x - fit.first)];
      const float r = static_cast<float>(grey) - model;
      out.samples.push_back({model, r * r * freedom});
    }
  }
  std::stable_sort(out.points.begin(), out.points.end(), [](const StripePoint& p, const StripePoint& q) {
    return p.v < q.v || (p.v == q.v && p.u < q.u);
  });
  return out;
}

}  // namespace

ProfileStart StartBetween(const std::vector<RidgeCandidate>& row, std::size_t i, double width, int cols) {
  ProfileStart start;
  start.u = static_cast<double>(row[i].u);
  start.width = width;
  start.last = cols - 1;
  if (i > 0) start.first = static_cast<int>(std::ceil(0.5 * static_cast<double>(row[i - 1].u + row[i].u)));
  if (i + 1 < row.size()) {
    start.last = static_cast<int>(std::floor(0.5 * static_cast<double>(row[i].u + row[i + 1].u)));
  }
  return start;
}

RidgeSurvey SurveyRidges(const cv::Mat& green, const cv::Mat& region, double width_px,
                         const RidgeDetectionOptions& detection, const ProfileFitOptions& fit,
                         const Context& context, const RowComb& rows) {
  RidgeSurvey survey;
  const double dark = std::max(kLeastVariance, DarkVariance(green, rows));
  // Photons: before anything is measured, a tenth of the grey value is usual.
  survey.noise = {dark, 0.1, 0.0};
  survey.width_px = width_px;
  for (const int sparser : {4, 1}) {
    const RowComb comb{rows.first, rows.step * sparser};
    const int count = (green.rows - comb.first + comb.step - 1) / comb.step;
    if (count <= 0) return survey;
    RidgeDetectionOptions look = detection;
    look.width_px = survey.width_px > 0.0 ? survey.width_px : 2.0;
    look.min_contrast = 8.0;
    const auto candidates = DetectRidges(green, region, survey.noise, look, context, comb);
    const int blocks = (count + kRowsTogether - 1) / kRowsTogether;
    std::vector<RowFindings> findings(static_cast<std::size_t>(blocks));
    ParallelFor(context, 0, blocks, [&](std::int64_t i) {
      const int first = comb.first + static_cast<int>(i) * kRowsTogether * comb.step;
      const int end = std::min(green.rows, first + kRowsTogether * comb.step);
      findings[static_cast<std::size_t>(i)] =
          SurveyRows(green, candidates, first, end, comb.step, look.width_px, survey.noise, fit);
    });
    std::vector<float> widths;
    std::vector<NoiseSample> samples;
    survey.points.clear();
    for (const RowFindings& f : findings) {
      widths.insert(widths.end(), f.widths.begin(), f.widths.end());
      samples.insert(samples.end(), f.samples.begin(), f.samples.end());
      survey.points.insert(survey.points.end(), f.points.begin(), f.points.end());
    }
    if (widths.empty()) continue;  // there may be stripes in the other rows
    if (width_px <= 0.0) survey.width_px = std::clamp(static_cast<double>(Median(widths)), 0.7, 8.0);
    survey.noise = FitNoiseModel(std::move(samples), survey.noise);
  }
  return survey;
}

}  // namespace dorsum
