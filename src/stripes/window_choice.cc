// SPDX-License-Identifier: Apache-2.0
#include "stripes/window_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stripes/window_choice.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef DORSUM_STRIPES_FRAMED_CURVE
#define DORSUM_STRIPES_FRAMED_CURVE
namespace dorsum {

// A curve with `frame` points without weight before and behind it. Where those count that an end cuts off a
// window, the curve's first and last stand for them.
struct FramedCurve {
  std::size_t frame = 0, count = 0;
  std::vector<double> angle, u, weight, sharpness;  // 1 / sd^2 and 1 / sd, 0 where not in use
  std::vector<double> fading;                       // what is left of the correlation with the point before
};

}  // namespace dorsum
#endif

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr std::size_t kLanes = hn::MaxLanes(D());

HWY_INLINE V Set(double value) { return hn::Set(D(), value); }

struct Estimate {
  M ok;
  V u, sd;
};

// The windows around as many neighbouring points as there are lanes.
class Windows {
 public:
  Windows(const FramedCurve& curve, std::size_t k, const WindowChoiceOptions& options)
      : c_(curve), k_(k), options_(options), here_(Load(curve.angle, 0)) {
    moments_.fill(Set(0.0));
    right_.fill(Set(0.0));
    rows_ = Set(0.0);
  }

  std::array<WindowChoice, kLanes> Choose() {
    std::array<Estimate, kMostWindows> tried;
    std::size_t count = 0;
    V u = Set(0.0), sd = Set(0.0), half = Set(0.0);
    M open = hn::Eq(u, u);
    const V confidence = Set(options_.confidence * options_.confidence);
    for (const int rows : options_.half_rows) {
      Widen(rows);
      Estimate fit = Solve(rows);
      M agrees = hn::And(open, fit.ok);
      for (std::size_t i = 0; i < count; ++i) {
        // A wider window holds the narrower one's rows, so the difference of their estimates has about the
        // difference of their variances (Hausman 1978), far less than either where they share most of the
        // noise.
        const V narrow = tried[i].sd * tried[i].sd, apart = fit.u - tried[i].u;
        const V variance = hn::Max(narrow - fit.sd * fit.sd, Set(0.1) * narrow);
        const M agree = hn::Le(apart * apart, confidence * variance);
        agrees = hn::And(agrees, hn::Or(agree, hn::Not(tried[i].ok)));
      }
      u = hn::IfThenElse(agrees, fit.u, u);
      sd = hn::IfThenElse(agrees, fit.sd, sd);
      half = hn::IfThenElse(agrees, Set(rows), half);
      // Those go on that agree, or had too few rows; but not beyond the whole curve.
      open = hn::And(open, hn::Or(agrees, hn::Not(fit.ok)));
      open = hn::And(open, hn::Not(hn::And(agrees, Whole(rows))));
      if (hn::AllFalse(D(), open)) break;
      fit.ok = agrees;
      tried[count++] = fit;
    }
    std::array<double, kLanes> us, sds, halves;
    hn::StoreU(u, D(), us.data());
    hn::StoreU(sd, D(), sds.data());
    hn::StoreU(half, D(), halves.data());
    std::array<WindowChoice, kLanes> out;
    for (std::size_t i = 0; i < kLanes; ++i) out[i] = {static_cast<int>(halves[i]), us[i], sds[i]};
    return out;
  }

 private:
  HWY_INLINE V Load(const std::vector<double>& values, int offset) const {
    return hn::LoadU(D(), values.data() + static_cast<std::ptrdiff_t>(k_ + c_.frame) + offset);
  }

  // Whether a window holds all of the curve.
  M Whole(int rows) const {
    const V at = hn::Iota(D(), static_cast<double>(k_)), last = Set(static_cast<double>(c_.count) - 1.0);
    return hn::And(hn::Le(at, Set(rows)), hn::Ge(at + Set(rows), last));
  }

  HWY_INLINE void Add(int offset) {
    const V w = Load(c_.weight, offset), t = Load(c_.angle, offset) - here_, u = Load(c_.u, offset);
    const V wt = w * t, wtt = wt * t, wttt = wtt * t;
    moments_[0] = moments_[0] + w;
    moments_[1] = moments_[1] + wt;
    moments_[2] = moments_[2] + wtt;
    moments_[3] = moments_[3] + wttt;
    moments_[4] = moments_[4] + wttt * t;
    right_[0] = right_[0] + w * u;
    right_[1] = right_[1] + wt * u;
    right_[2] = right_[2] + wtt * u;
    rows_ = rows_ + hn::IfThenElseZero(hn::Gt(w, Set(0.0)), Set(1.0));
  }

  void Widen(int rows) {
    if (next_ == 0) Add(0);
    for (next_ = std::max(next_, 1); next_ <= rows; ++next_) {
      Add(-next_);
      Add(next_);
    }
  }

  Estimate Solve(int rows) const {
    constexpr double kLeastRows = 5.0;
    // In half windows, so that the moments are of one size.
    const V length = Set(0.5) * (Load(c_.angle, rows) - Load(c_.angle, -rows));
    const V scale = Set(1.0) / hn::Max(Set(1e-6), length);
    std::array<V, 5> s = moments_;
    V power = scale;
    for (std::size_t i = 1; i < 5; ++i) {
      s[i] = s[i] * power;
      power = power * scale;
    }
    // The first row of the inverse of the symmetric matrix of the moments, by its adjugate.
    const V a = s[2] * s[4] - s[3] * s[3], b = s[2] * s[3] - s[1] * s[4], e = s[1] * s[3] - s[2] * s[2];
    const V determinant = s[0] * a + s[1] * b + s[2] * e;
    Estimate out;
    out.ok = hn::And(hn::Ge(rows_, Set(kLeastRows)), hn::Gt(determinant, Set(1e-9) * s[0] * s[2] * s[4]));
    const V inverse = Set(1.0) / hn::IfThenElse(out.ok, determinant, Set(1.0));
    const V c0 = a * inverse, c1 = b * inverse * scale, c2 = e * inverse * scale * scale;
    out.u = c0 * right_[0] + c1 * right_[1] + c2 * right_[2];
    // The estimate is a sum of g_i u_i. Its variance is sum g_i^2 s_i^2 + 2 share sum_i g_i s_i S_i, where
    // S_i gathers the earlier rows' g s, each shrunk by `decay` per row.
    V variance = Set(0.0), earlier = Set(0.0);
    const V twice_share = Set(2.0 * options_.correlation.share);
    for (int i = -rows; i <= rows; ++i) {
      const V t = Load(c_.angle, i) - here_;
      const V g = (c0 + t * (c1 + t * c2)) * Load(c_.sharpness, i);
      earlier = earlier * Load(c_.fading, i);
      variance = variance + g * (g + twice_share * earlier);
      earlier = earlier + g;
    }
    out.sd = hn::Sqrt(hn::Max(variance, Set(1e-12))) * Set(options_.scale);
    return out;
  }

  const FramedCurve& c_;
  std::size_t k_;
  const WindowChoiceOptions& options_;
  V here_;
  std::array<V, 5> moments_;  // of the angle from the window's middle
  std::array<V, 3> right_;
  V rows_;
  int next_ = 0;  // the row that the window does not hold yet, from its middle
};

void Choose(const FramedCurve& curve, std::size_t first, std::size_t every,
            const WindowChoiceOptions& options, std::vector<WindowChoice>* out) {
  for (std::size_t k = first; k<curve.count; k += every> 1 ? every : kLanes) {
    const auto found = Windows(curve, k, options).Choose();
    const std::size_t wanted = every > 1 ? 1 : std::min(kLanes, curve.count - k);
    out->insert(out->end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(wanted));
  }
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {
namespace {

FramedCurve Frame(const StripeCurve& curve, std::size_t frame, double decay) {
  constexpr std::size_t kMostLanes = 8;  // which may look behind the last point's window
  FramedCurve out;
  out.frame = frame;
  out.count = curve.v.size();
  const std::size_t size = out.count + 2 * frame + kMostLanes;
  for (auto* values : {&out.angle, &out.u, &out.weight, &out.sharpness}) values->assign(size, 0.0);
  out.fading.assign(size, 1.0);
  std::fill(out.angle.begin(), out.angle.end(), curve.angle.back());
  std::fill_n(out.angle.begin(), frame, curve.angle.front());
  for (std::size_t i = 0; i < out.count; ++i) {
    const std::size_t at = i + frame;
    out.angle[at] = curve.angle[i];
    out.u[at] = curve.u[i];
    if (i > 0) out.fading[at] = std::pow(decay, std::round(curve.v[i] - curve.v[i - 1]));
    if (curve.use[i] == 0) continue;
    out.sharpness[at] = 1.0 / curve.sd[i];
    out.weight[at] = out.sharpness[at] * out.sharpness[at];
  }
  return out;
}

}  // namespace

HWY_EXPORT(Choose);

std::vector<WindowChoice> ChooseWindows(const StripeCurve& curve, std::size_t first, std::size_t every,
                                        const WindowChoiceOptions& options) {
  if (options.half_rows.size() > kMostWindows) throw std::logic_error("ChooseWindows: too many windows");
  std::vector<WindowChoice> out;
  if (options.half_rows.empty() || curve.v.empty()) return out;
  const FramedCurve framed =
      Frame(curve, static_cast<std::size_t>(options.half_rows.back()), options.correlation.decay);
  out.reserve(framed.count);
  HWY_DYNAMIC_DISPATCH(Choose)(framed, first, every, options, &out);
  return out;
}

}  // namespace dorsum
#endif
