// SPDX-License-Identifier: Apache-2.0
#include "surface/plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace dorsum {
namespace {

// Where a pixel lies between the nodes of a lattice.
struct Place {
  int c = 0, r = 0;
  float fc = 0.0F, fr = 0.0F;
};

bool FindPlace(const PlateLattice& l, double u, double v, Place* out) {
  const double x = (u - l.u0) / l.step_px, y = (v - l.v0) / l.step_px;
  if (!(x >= 0.0 && y >= 0.0 && x < l.active.cols - 1 && y < l.active.rows - 1)) return false;
  out->c = static_cast<int>(x);
  out->r = static_cast<int>(y);
  out->fc = static_cast<float>(x - out->c);
  out->fr = static_cast<float>(y - out->r);
  const std::uint8_t* top = l.active.ptr(out->r) + out->c;
  const std::uint8_t* bottom = l.active.ptr(out->r + 1) + out->c;
  return top[0] != 0 && top[1] != 0 && bottom[0] != 0 && bottom[1] != 0;
}

// The symmetric matrix of the normal equations: for each node its diagonal and the coefficients towards the
// six neighbours that come later; a frame of two empty nodes on every side spares all tests at borders.
struct Stencil {
  static constexpr int kFrame = 2;
  explicit Stencil(cv::Size size)
      : cols(size.width + 2 * kFrame),
        rows(size.height + 2 * kFrame),
        offsets{1, 2, cols - 1, cols, cols + 1, 2 * cols} {
    diagonal.assign(Count(), 0.0F);
    right.assign(Count(), 0.0F);
    inverse.assign(Count(), 0.0F);
    for (auto& c : upper) c.assign(Count(), 0.0F);
  }
  std::size_t Count() const { return static_cast<std::size_t>(cols) * static_cast<std::size_t>(rows); }
  std::size_t At(int c, int r) const {
    return static_cast<std::size_t>(r + kFrame) * static_cast<std::size_t>(cols) +
           static_cast<std::size_t>(c + kFrame);
  }
  // Adds weight * (sum a_i z_i - value)^2.
  template <std::size_t N>
  void Add(const std::array<std::size_t, N>& at, const std::array<float, N>& a, float weight, float value) {
    for (std::size_t i = 0; i < N; ++i) {
      diagonal[at[i]] += weight * a[i] * a[i];
      right[at[i]] += weight * a[i] * value;
      for (std::size_t j = i + 1; j < N; ++j) {
        const auto distance = static_cast<int>(at[j] - at[i]);
        const auto k =
            static_cast<std::size_t>(std::find(offsets.begin(), offsets.end(), distance) - offsets.begin());
        upper[k][at[i]] += weight * a[i] * a[j];
      }
    }
  }

  int cols, rows;
  std::array<int, 6> offsets;
  std::vector<float> diagonal, right, inverse;
  std::array<std::vector<float>, 6> upper;
};

void AddSamples(const std::vector<PlateSample>& samples, const PlateLattice& l, Stencil* s) {
  for (const PlateSample& p : samples) {
    Place at;
    if (p.weight <= 0.0F || !FindPlace(l, p.u, p.v, &at)) continue;
    const std::size_t i = s->At(at.c, at.r), below = s->At(at.c, at.r + 1);
    s->Add<4>({i, i + 1, below, below + 1},
              {(1 - at.fc) * (1 - at.fr), at.fc * (1 - at.fr), (1 - at.fc) * at.fr, at.fc * at.fr}, p.weight,
              p.z);
  }
}

void AddBending(const PlateOptions& options, const PlateLattice& l, Stencil* s) {
  const double h = options.mm_per_px * l.step_px;
  const auto scale = static_cast<float>(1.0 / (h * h));
  const auto tension = static_cast<float>(options.tension);
  const auto on = [&](int c, int r) {
    return c >= 0 && r >= 0 && c < l.active.cols && r < l.active.rows && l.active(r, c) != 0;
  };
  for (int r = 0; r < l.active.rows; ++r) {
    for (int c = 0; c < l.active.cols; ++c) {
      if (!on(c, r)) continue;
      const std::size_t i = s->At(c, r);
      const auto wide = static_cast<std::size_t>(s->cols);
      const bool e = on(c + 1, r), n = on(c, r + 1);
      if (on(c - 1, r) && e) {
        s->Add<3>({i - 1, i, i + 1}, {1.0F, -2.0F, 1.0F}, scale * l.stiffness(r, c)[0], 0.0F);
      }
      if (on(c, r - 1) && n) {
        s->Add<3>({i - wide, i, i + wide}, {1.0F, -2.0F, 1.0F}, scale * l.stiffness(r, c)[2], 0.0F);
      }
      if (e && n && on(c + 1, r + 1)) {
        s->Add<4>({i, i + 1, i + wide, i + wide + 1}, {1.0F, -1.0F, -1.0F, 1.0F},
                  2.0F * scale * l.stiffness(r, c)[1], 0.0F);
      }
      if (e) s->Add<2>({i, i + 1}, {-1.0F, 1.0F}, tension, 0.0F);
      if (n) s->Add<2>({i, i + wide}, {-1.0F, 1.0F}, tension, 0.0F);
    }
  }
  for (std::size_t i = 0; i < s->Count(); ++i)
    s->inverse[i] = s->diagonal[i] > 0.0F ? 1.0F / s->diagonal[i] : 0.0F;
}

// sum a[i] * b[i], in lanes that do not wait for each other.
double Dot(const float* a, const float* b, std::size_t count) {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> lane{};
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) lane[k] += static_cast<double>(a[i + k] * b[i + k]);
  }
  for (; i < count; ++i) lane[0] += static_cast<double>(a[i] * b[i]);
  double sum = 0.0;
  for (const double l : lane) sum += l;
  return sum;
}

// Conjugate gradients with a diagonal preconditioner. In one thread: a step is over sooner than it is handed
// to others.
class Gradients {
 public:
  explicit Gradients(const Stencil& s) : s_(s) {
    const auto wide = static_cast<std::size_t>(s.cols);
    for (std::size_t r = 0; r < static_cast<std::size_t>(s.rows); ++r) {
      std::size_t begin = r * wide, end = begin + wide;
      while (begin < end && s.inverse[begin] == 0.0F) ++begin;
      while (begin < end && s.inverse[end - 1] == 0.0F) --end;
      if (begin < end) spans_.emplace_back(begin, end);
    }
  }

  int Solve(const PlateOptions& options, std::vector<float>* x) {
    std::vector<float> residual(s_.Count(), 0.0F), direction(s_.Count(), 0.0F), image(s_.Count(), 0.0F);
    std::vector<float> scaled(s_.Count(), 0.0F);  // the residual, preconditioned
    const float* inverse = s_.inverse.data();
    double rho = SumRows([&](std::size_t begin, std::size_t end) {
      Multiply(*x, begin, end, &image);
      for (std::size_t i = begin; i < end; ++i) {
        residual[i] = s_.right[i] - image[i];
        direction[i] = inverse[i] * residual[i];
      }
      return Dot(&residual[begin], &direction[begin], end - begin);
    });
    const double enough = rho * options.tolerance * options.tolerance;
    int iteration = 0;
    for (; iteration < options.max_iterations && rho > enough && rho > 0.0; ++iteration) {
      const double curvature = SumRows([&](std::size_t begin, std::size_t end) {
        Multiply(direction, begin, end, &image);
        return Dot(&direction[begin], &image[begin], end - begin);
      });
      if (!(curvature > 0.0)) break;
      const auto alpha = static_cast<float>(rho / curvature);
      const double next = SumRows([&](std::size_t begin, std::size_t end) {
        float *to = x->data(), *left = residual.data(), *s = scaled.data();
        const float *d = direction.data(), *image_of_d = image.data();
        for (std::size_t i = begin; i < end; ++i) {
          to[i] += alpha * d[i];
          left[i] -= alpha * image_of_d[i];
          s[i] = inverse[i] * left[i];
        }
        return Dot(left + begin, s + begin, end - begin);
      });
      const auto beta = static_cast<float>(next / rho);
      rho = next;
      SumRows([&](std::size_t begin, std::size_t end) {
        float* d = direction.data();
        const float* s = scaled.data();
        for (std::size_t i = begin; i < end; ++i) d[i] = s[i] + beta * d[i];
        return 0.0;
      });
    }
    return iteration;
  }

 private:
  void Multiply(const std::vector<float>& x, std::size_t begin, std::size_t end,
                std::vector<float>* out) const {
    float* __restrict y = out->data();
    const float *in = x.data(), *diagonal = s_.diagonal.data();
    for (std::size_t i = begin; i < end; ++i) y[i] = diagonal[i] * in[i];
    // Two diagonals at a time: more do not fit the registers, fewer go over y too often.
    for (std::size_t k = 0; k < s_.offsets.size(); k += 2) {
      const float *a = s_.upper[k].data(), *b = s_.upper[k + 1].data();
      const std::ptrdiff_t d = s_.offsets[k], e = s_.offsets[k + 1];
      for (auto i = static_cast<std::ptrdiff_t>(begin); i < static_cast<std::ptrdiff_t>(end); ++i) {
        y[i] += a[i] * in[i + d] + a[i - d] * in[i - d] + b[i] * in[i + e] + b[i - e] * in[i - e];
      }
    }
  }

  template <class Body>
  double SumRows(const Body& body) const {
    double sum = 0.0;
    for (const auto& [begin, end] : spans_) sum += body(begin, end);
    return sum;
  }

  const Stencil& s_;
  std::vector<std::pair<std::size_t, std::size_t>> spans_;  // of each row, from its first to its last node
};

}  // namespace

int SolvePlate(const std::vector<PlateSample>& samples, const PlateOptions& options, PlateLattice* lattice) {
  PlateLattice& l = *lattice;
  Stencil s(l.active.size());
  AddSamples(samples, l, &s);
  AddBending(options, l, &s);
  std::vector<float> x(s.Count(), 0.0F);
  for (int r = 0; r < l.z.rows; ++r) {
    for (int c = 0; c < l.z.cols; ++c) x[s.At(c, r)] = l.active(r, c) != 0 ? l.z(r, c) : 0.0F;
  }
  const int iterations = Gradients(s).Solve(options, &x);
  for (int r = 0; r < l.z.rows; ++r) {
    for (int c = 0; c < l.z.cols; ++c) l.z(r, c) = l.active(r, c) != 0 ? x[s.At(c, r)] : 0.0F;
  }
  return iterations;
}

PlateLattice Coarsen(const PlateLattice& fine) {
  PlateLattice out;
  out.u0 = fine.u0;
  out.v0 = fine.v0;
  out.step_px = 2.0 * fine.step_px;
  out.active = cv::Mat1b((fine.active.rows + 2) / 2 + 1, (fine.active.cols + 2) / 2 + 1, std::uint8_t{0});
  out.z = cv::Mat1f(out.active.size(), 0.0F);
  for (int r = 0; r < fine.active.rows; ++r) {
    for (int c = 0; c < fine.active.cols; ++c) {
      if (fine.active(r, c) == 0) continue;
      for (int y = r / 2; y <= (r + 1) / 2; ++y) {
        for (int x = c / 2; x <= (c + 1) / 2; ++x) out.active(y, x) = 255;
      }
    }
  }
  return out;
}

void Prolong(const PlateLattice& coarse, PlateLattice* fine) {
  for (int r = 0; r < fine->active.rows; ++r) {
    for (int c = 0; c < fine->active.cols; ++c) {
      if (fine->active(r, c) == 0) continue;
      const int r0 = r / 2, r1 = (r + 1) / 2, c0 = c / 2, c1 = (c + 1) / 2;
      fine->z(r, c) = 0.25F * (coarse.z(r0, c0) + coarse.z(r0, c1) + coarse.z(r1, c0) + coarse.z(r1, c1));
    }
  }
}

float HeightAt(const PlateLattice& lattice, double u, double v) {
  Place at;
  if (!FindPlace(lattice, u, v, &at)) return std::numeric_limits<float>::quiet_NaN();
  const float* top = lattice.z.ptr<float>(at.r) + at.c;
  const float* bottom = lattice.z.ptr<float>(at.r + 1) + at.c;
  const float a = top[0] + at.fc * (top[1] - top[0]), b = bottom[0] + at.fc * (bottom[1] - bottom[0]);
  return a + at.fr * (b - a);
}

}  // namespace dorsum
