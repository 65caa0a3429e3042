// SPDX-License-Identifier: Apache-2.0
#include "stripes/profile_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace dorsum {
namespace {

using Vector4 = std::array<double, 4>;  // centre, width, amplitude, background
using Matrix4 = std::array<Vector4, 4>;

constexpr std::size_t kMostColumns = 256;  // of a window; what lies beyond is left out

// Solves A x = b for a symmetric positive definite A, of which the lower half is given; false if it is not.
bool SolveCholesky(Matrix4 a, Vector4 b, Vector4* x) {
  Vector4 inverse{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = sum * inverse[j];
    }
    double sum = a[i][i];
    for (std::size_t k = 0; k < i; ++k) sum -= a[i][k] * a[i][k];
    if (!(sum > 1e-12 * a[i][i]) || !(sum > 0.0)) return false;
    inverse[i] = 1.0 / std::sqrt(sum);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] *= inverse[i];
  }
  for (std::size_t i = 4; i-- > 0;) {
    for (std::size_t k = i + 1; k < 4; ++k) b[i] -= a[k][i] * b[k];
    b[i] *= inverse[i];
  }
  *x = b;
  return true;
}

// Normal equations of the four unknowns at one state, and the weighted sum of squares.
struct Equations {
  Matrix4 matrix{};
  Vector4 right{};
  double cost = 0.0;
};

// exp(-t^2 / 2) for the columns [first, last], each from its neighbour nearer to the centre: the quotient of
// two neighbours changes by a constant factor from column to column.
void FillShape(const ProfileFit& fit, double* shape) {
  const double inverse = 1.0 / fit.width, bend = std::exp(-inverse * inverse);
  const int middle = std::clamp(static_cast<int>(std::lround(fit.u)), fit.first, fit.last);
  const double t = (middle - fit.u) * inverse;
  const double peak = std::exp(-0.5 * t * t), root = std::sqrt(bend);
  const double slope = std::exp(-t * inverse);
  shape[middle - fit.first] = peak;
  double value = peak, step = slope * root;
  for (int x = middle + 1; x <= fit.last; ++x, step *= bend) shape[x - fit.first] = value *= step;
  value = peak;
  step = root / slope;
  for (int x = middle - 1; x >= fit.first; --x, step *= bend) shape[x - fit.first] = value *= step;
}

Equations Linearise(const std::uint8_t* row, const ProfileStart& start, const ProfileFit& fit,
                    const NoiseModel& noise, int saturated) {
  Equations e;
  std::array<double, kMostColumns> shapes;
  FillShape(fit, shapes.data());
  const double inverse = 1.0 / fit.width;
  double product = 1.0;  // of the weights since the last logarithm
  for (int x = fit.first; x <= fit.last; ++x) {
    const double gain = start.gain == nullptr ? 1.0 : static_cast<double>(start.gain[x]);
    if (gain <= 0.0) continue;
    const double t = (x - fit.u) * inverse;
    const double shape = gain * shapes[static_cast<std::size_t>(x - fit.first)];
    const double signal = fit.amplitude * shape;
    const double model = gain * fit.background + signal;
    double residual = static_cast<double>(row[x]) - model;
    if (row[x] >= saturated) {
      residual = saturated - model;
      if (residual <= 0.0) continue;
    }
    const double weight = 1.0 / noise.Variance(std::min(model, 255.0));
    const double slope = signal * t * inverse;
    const Vector4 jacobian = {slope, slope * t, shape, gain};
    for (std::size_t i = 0; i < 4; ++i) {
      const double wj = weight * jacobian[i];
      for (std::size_t j = 0; j <= i; ++j) e.matrix[i][j] += wj * jacobian[j];
      e.right[i] += wj * residual;
    }
    // The weights move with the model, so the cost holds their logarithm too: the likelihood.
    e.cost += weight * residual * residual;
    product *= weight;
    if (!(product > 1e-200 && product < 1e200)) {
      e.cost -= std::log(product);
      product = 1.0;
    }
  }
  e.cost -= std::log(product);
  if (start.amplitude_sd > 0.0) {
    const double weight = 1.0 / (start.amplitude_sd * start.amplitude_sd);
    const double residual = start.amplitude - fit.amplitude;
    e.matrix[2][2] += weight;
    e.right[2] += weight * residual;
    e.cost += weight * residual * residual;
  }
  return e;
}

// Takes the width out of the equations.
void HoldWidth(Equations* e) {
  for (std::size_t j = 0; j < 4; ++j) {
    if (j <= 1) e->matrix[1][j] = 0.0;
    if (j > 1) e->matrix[j][1] = 0.0;
  }
  e->matrix[1][1] = 1.0;
  e->right[1] = 0.0;
}

void SetWindow(const ProfileStart& start, const ProfileFitOptions& options, double u, double width,
               ProfileFit* fit) {
  constexpr double kMostHalf = 0.5 * static_cast<double>(kMostColumns) - 1.0;
  const double half = std::clamp(options.half_window_sd * width, 3.0, kMostHalf);
  fit->first = std::max(start.first, static_cast<int>(std::ceil(u - half)));
  fit->last = std::min(start.last, static_cast<int>(std::floor(u + half)));
}

// Returns the number of pixels that are seen.
int Begin(const std::uint8_t* row, const ProfileStart& start, const ProfileFitOptions& options,
          ProfileFit* fit) {
  int seen = 0;
  fit->u = start.u;
  fit->width = start.width;
  SetWindow(start, options, start.u, start.width, fit);
  double low = 1e9, high = 0.0;
  for (int x = fit->first; x <= fit->last; ++x) {
    const double gain = start.gain == nullptr ? 1.0 : static_cast<double>(start.gain[x]);
    if (gain <= 0.0) continue;
    ++seen;
    low = std::min(low, row[x] / std::max(0.2, gain));
    high = std::max(high, row[x] / std::max(0.5, gain));
    fit->clipped += row[x] >= options.saturated_grey ? 1 : 0;
  }
  fit->background = std::min(low, high);
  fit->amplitude = std::max(1.0, high - fit->background + (fit->clipped > 0 ? 20.0 : 0.0));
  return seen;
}

bool IsSane(const ProfileFit& fit, const ProfileStart& start, const ProfileFitOptions& options) {
  const double beyond = start.hold_width ? start.width : 0.0;
  return std::isfinite(fit.u) && fit.u > fit.first - beyond && fit.u < fit.last + beyond &&
         std::abs(fit.u - start.u) < 1.5 * std::max(fit.width, start.width) && fit.amplitude > 0.0 &&
         fit.amplitude < 5000.0 && fit.width >= options.min_width_px && fit.width <= options.max_width_px;
}

// Levenberg-Marquardt until the centre stands; false when the equations give out.
bool Iterate(const std::uint8_t* row, const ProfileStart& start, const NoiseModel& noise,
             const ProfileFitOptions& options, ProfileFit* fit, Equations* at) {
  double damping = 1e-3;
  *at = Linearise(row, start, *fit, noise, options.saturated_grey);
  for (int i = 0; i < options.max_iterations; ++i) {
    Equations damped = *at;
    if (fit->width_held) HoldWidth(&damped);
    for (std::size_t k = 0; k < 4; ++k) damped.matrix[k][k] *= 1.0 + damping;
    Vector4 step{};
    if (!SolveCholesky(damped.matrix, damped.right, &step)) return false;
    ProfileFit next = *fit;
    const double reach = 0.7 * fit->width;
    next.u += std::clamp(step[0], -reach, reach);
    next.width = std::clamp(fit->width + step[1], 0.6 * fit->width, 1.7 * fit->width);
    next.amplitude += step[2];
    next.background += step[3];
    if (!IsSane(next, start, options)) {
      damping = damping * 10.0 + 1e-2;
      if (damping > 1e6) return false;
      continue;
    }
    const Equations there = Linearise(row, start, next, noise, options.saturated_grey);
    if (there.cost > at->cost + 1e-9) {
      damping = damping * 10.0;
      if (damping > 1e6) return true;
      continue;
    }
    // Steps shrink at least tenfold here, so what is left of the centre is far below its noise.
    const bool done = std::abs(step[0]) < 1e-2 && std::abs(step[1]) < 2e-2 * fit->width &&
                      std::abs(step[2]) < 1e-2 * fit->amplitude + 0.05;
    *fit = next;
    *at = there;
    damping *= 0.1;
    if (done) return true;
  }
  return true;
}

bool FormalSd(Equations at, bool width_held, ProfileFit* fit) {
  if (width_held) HoldWidth(&at);
  Vector4 column{};
  if (!SolveCholesky(at.matrix, {1.0, 0.0, 0.0, 0.0}, &column)) return false;
  fit->sd_u = std::sqrt(column[0]);
  return std::isfinite(fit->sd_u);
}

ProfileFit Attempt(const std::uint8_t* row, const ProfileStart& start, const NoiseModel& noise,
                   const ProfileFitOptions& options, bool hold_width) {
  ProfileFit fit;
  const int seen = Begin(row, start, options, &fit);
  fit.width_held = hold_width;
  if (seen < 5) return fit;
  Equations at;
  fit.ok = Iterate(row, start, noise, options, &fit, &at) && FormalSd(at, hold_width, &fit);
  return fit;
}

}  // namespace

double ProfileFit::At(double column) const {
  const double t = (column - u) / width;
  return background + amplitude * std::exp(-0.5 * t * t);
}

ProfileFit FitProfile(const std::uint8_t* row, const ProfileStart& start, const NoiseModel& noise,
                      const ProfileFitOptions& options) {
  if (start.hold_width) return Attempt(row, start, noise, options, true);
  ProfileFit fit = Attempt(row, start, noise, options, false);
  // A profile much wider or narrower than the start's asks for its own window.
  const double wanted = std::max(3.0, options.half_window_sd * fit.width);
  const double had = std::max(3.0, options.half_window_sd * start.width);
  if (fit.ok && (wanted > 1.25 * had || wanted < 0.7 * had)) {
    ProfileStart again = start;
    again.u = fit.u;
    again.width = fit.width;
    const ProfileFit better = Attempt(row, again, noise, options, false);
    if (better.ok && std::abs(better.u - start.u) < 1.5 * std::max(better.width, start.width)) fit = better;
  }
  if (!fit.ok) fit = Attempt(row, start, noise, options, true);
  return fit;
}

}  // namespace dorsum
